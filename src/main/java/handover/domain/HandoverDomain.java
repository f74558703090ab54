package handover.domain;

import burlap.behavior.singleagent.auxiliary.StateEnumerator;
import burlap.debugtools.RandomFactory;
import burlap.mdp.auxiliary.DomainGenerator;
import burlap.mdp.core.state.State;
import burlap.mdp.singleagent.pomdp.PODomain;
import burlap.statehashing.ReflectiveHashableStateFactory;
import handover.math.AngularGaussian;
import handover.math.MatchScore;
import handover.math.Simplex;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.random.RandomGenerator;

/**
 * The base handover domain (MODEL sections 1-6): the problem stated once, in small pure methods ("seams"), from which the
 * BURLAP view, the filter, the search, the simulator and the bridge all follow. A variant overrides one to three of the
 * protected methods. Immutable, thread safe.
 *
 * <p>Source: "Progress Report: Social Feedback for Robotic Collaboration", section 2.1.
 */
public class HandoverDomain implements DomainGenerator {
    /** The human never speaks more surely than this. */
    private static final double MOST_SPEECH = 0.99;

    private final DomainSpec spec;
    private final Vocabulary vocabulary;
    private final AngularGaussian pointing;
    private final MatchScore matchScore;
    private final double matchWeight;
    private final double tauHuman;
    private final ActModel idle;
    /** What a variant may change; made when it is first needed, once the variant's own constructor is through. */
    private volatile Rules rules;

    private record Rules(List<ActType> types, PickRule pickRule, Scene start) {}

    /**
     * The domain that a domain file describes. An act without parameters is found when the acts are first needed, with
     * {@link InvalidParameterException}.
     */
    public HandoverDomain(DomainSpec spec) {
        this.spec = spec;
        this.vocabulary = new Vocabulary(spec.objects(), spec.speech().alpha());
        this.pointing = new AngularGaussian(spec.gesture().variance(), spec.gesture().outliers());
        this.matchScore = spec.rewards().matchScore();
        this.matchWeight = spec.rewards().matchWeight();
        this.tauHuman = spec.tauHuman();
        this.idle = new ActModel(0, Act.WAIT, new WaitType(spec.act("wait")), new double[0], null, -1, "");
    }

    private Rules rules() {
        Rules r = rules;
        if (r == null) {
            synchronized (this) {
                r = rules == null ? new Rules(List.copyOf(actTypes()), createPickRule(), new Scene(this, spec.objects())) : rules;
                rules = r;
            }
        }
        return r;
    }

    // ---- seams: what a variant overrides -------------------------------------------------------------------------

    /** The types of act on offer. Called once, when the acts are first needed. */
    protected List<ActType> actTypes() {
        List<ActType> all = new ArrayList<>();
        all.add(new WaitType(spec.act("wait")));
        all.add(new PickType(spec.act("pick"), spec.understanding().pickError()));
        all.add(new AskType(spec.act("ask"), spec.ask().sets(), vocabulary));
        all.add(new DirectedType(DirectedType.POINT, spec.act("point"), spec.pointingOrigin(),
                spec.understanding().sigmaPoint()));
        all.add(new DirectedType(DirectedType.LOOK, spec.act("look"), spec.pointingOrigin(),
                spec.understanding().sigmaLook()));
        return all;
    }

    /** How a pick goes on (MODEL 5). Called once, like {@link #actTypes()}. */
    protected PickRule createPickRule() {
        return PickRule.IMMEDIATE;
    }

    /**
     * U(h, a), the human's belief after an act (MODEL 3.2).
     *
     * @param h before, not modified
     * @param out after; another array than {@code h}; modified
     */
    public void understand(ActModel act, double[] h, double[] out, int n) {
        Simplex.update(tauHuman, h, act.lambda(), out, n);
    }

    /**
     * What the human may take an act for (MODEL 8): by default as {@code perception} of the spec says. Asked once for each act
     * of a scene that refers to something and is no pick; every other act is perceived as it is.
     *
     * @param offered all acts of the scene, of which those that are given must be
     * @return a distribution
     */
    protected List<Percept> percepts(ActModel act, List<ActModel> offered) {
        return spec.perception().exact() ? Percept.exact(act) : Percept.of(act, offered, spec.perception());
    }

    /**
     * The price of an act, with annoyance: what does not depend on any belief and does not complete a pick (MODEL 6). Searches take
     * an act to be dearest or cheapest at the start of an episode or as the open reference; a variant in which an act pays more in
     * other tasks changes what they leave out (rule 18 of the contract finds that).
     */
    public double actReward(Task before, ActModel act) {
        boolean annoying = act.isCommunicative() && act.act().equals(before.openReference());
        return act.type().parameters().reward() + (annoying ? spec.rewards().annoyance() : 0);
    }

    /** Paid when a pick completes. */
    public double pickReward(boolean right) {
        return right ? spec.rewards().right() : spec.rewards().wrong();
    }

    /**
     * kappa S(b, h'), paid on every step (MODEL 6).
     *
     * @param b belief about the wanted object, before the observation; not modified. Where h is uncertain: for scores of
     *     states given h, so that the expectation over h is that of the states
     * @param h the human's belief after the act; not modified
     */
    public double matchReward(double[] b, double[] h, int n) {
        return matchWeight * matchScore.of(b, h, n);
    }

    /**
     * An upper bound of {@link #matchReward} at {@code b} over all that the human may believe, by which searches prune; a
     * variant that changes one changes both. It must be largest where b is sure of something, or the same for all b.
     *
     * @param b belief about the wanted object; not modified
     */
    public double matchBound(double[] b, int n) {
        return matchWeight * matchScore.max(b, n);
    }

    /** Whether {@link #matchReward} is a reward of the belief that no reward of states has as its expectation. */
    public boolean beliefDependentReward() {
        return spec.rewards().matchScore().beliefDependent();
    }

    /** How long one act of this type takes, in seconds (MODEL 9); of a pick, one increment. */
    public double seconds(ActType type) {
        double whole = type.parameters().duration();
        return type.verb().equals(PickType.VERB) ? whole / pickRule().increments() : whole;
    }

    /**
     * P(the human says content words) (MODEL 4.1).
     *
     * @param type of the act
     * @param hWanted how much the human expects to get what they want, h'(omega)
     */
    public double contentRate(ActType type, double hWanted) {
        double rate = type.parameters().speechRate() + spec.speech().surprise() * (1 - hWanted);
        return vocabulary.size() == 0 ? 0 : Math.max(0, Math.min(MOST_SPEECH, rate));
    }

    /**
     * P(answer) to an act that the human takes to mean the wanted object with probability {@code match} (MODEL 4.1). The
     * three answers sum to one.
     */
    public double answerProbability(Answer answer, ActType type, double match) {
        double e = spec.speech().answerError();
        double ifMatch = type.parameters().answerIfMatch();
        double ifMiss = type.parameters().answerIfMiss();
        double miss = 1 - match;
        return switch (answer) {
            case YES -> match * ifMatch * (1 - e) + miss * ifMiss * e;
            case NO -> match * ifMatch * e + miss * ifMiss * (1 - e);
            case NONE -> match * (1 - ifMatch) + miss * (1 - ifMiss);
        };
    }

    // ---- what follows --------------------------------------------------------------------------------------------

    public final DomainSpec spec() {
        return spec;
    }

    public final Vocabulary vocabulary() {
        return vocabulary;
    }

    public final List<ActType> types() {
        return rules().types;
    }

    /** How a pick goes on. */
    public final PickRule pickRule() {
        return rules().pickRule;
    }

    /** gamma. */
    public final double discount() {
        return spec.rewards().discount();
    }

    /** The density of a gesture around the direction to the object that is meant. */
    public final AngularGaussian pointing() {
        return pointing;
    }

    /** The table at the start of an episode. */
    public final Scene start() {
        return rules().start;
    }

    /** A table with other objects or other positions, for instance after something was moved. */
    public final Scene scene(List<TableObject> objects) {
        return objects.equals(spec.objects()) ? start() : new Scene(this, objects);
    }

    /** The task at the start of an episode with these objects. */
    public final Task task(Scene scene) {
        return scene.task(Task.Key.START);
    }

    /** The probability of b_0 for each object of a scene: the file's prior where it is about these objects, else uniform. */
    public final double[] prior(Scene scene) {
        double[] given = scene.objects().stream()
                .mapToDouble(o -> spec.prior().getOrDefault(o.name(), 0.0)).toArray();
        return Simplex.normalise(given, given.length) > 0 ? given : Simplex.uniform(scene.size());
    }

    /** The expected reward of a completed pick of an object that is wanted with probability {@code right}. */
    public final double expectedPickReward(double right) {
        return right * pickReward(true) + (1 - right) * pickReward(false);
    }

    /** The human's belief after an act, as a new array; {@code h} is not modified. */
    public final double[] understood(ActModel act, double[] h) {
        double[] out = new double[h.length];
        understand(act, h, out, h.length);
        return out;
    }

    Task complete(Task during, boolean right) {
        Scene scene = during.scene();
        boolean leaves = right || spec.wrongPick() == WrongPick.REMOVED;
        Scene next = leaves ? scene.without(scene.indexOf(during.target())) : scene;
        int handovers = during.handovers() + (right ? 1 : 0);
        boolean done = handovers >= spec.handovers() || next.size() == 0
                || !right && spec.wrongPick() == WrongPick.TERMINAL;
        return next.task(new Task.Key(null, Answer.NONE, null, 0, right ? PickSignal.ACCEPTED : PickSignal.REJECTED,
                handovers, done));
    }

    ActModel idle() {
        return idle;
    }

    ActEffect effect(Task before, ActModel act) {
        PickRule pickRule = pickRule();
        if (!act.isPick()) {
            Act reference = act.isCommunicative() ? act.act() : before.openReference();
            ActModel open = reference == null ? null : before.scene().model(reference);
            return effect(before, act, null, 0, open, open == null ? null : open.match(), null);
        }
        String target = act.act().objects().get(0);
        boolean onward = target.equals(before.target()) && before.progress() < pickRule.increments();
        int progress = onward ? before.progress() : 0;
        ActEffect stalled = pickRule.advance() == 1 ? null
                : effect(before, act, target, progress, null, act.match(), null);
        return effect(before, act, target, progress + 1, null, act.match(), stalled);
    }

    private ActEffect effect(Task before, ActModel act, String target, int progress, ActModel open, double[] match,
            ActEffect stalled) {
        PickRule pickRule = pickRule();
        boolean completes = progress == pickRule.increments();
        boolean moves = progress > 0 && !completes && (pickRule.advance() == 1 || stalled != null);
        Task during = before.with(new Task.Key(open == null ? null : open.act(), Answer.NONE, target, progress,
                moves ? PickSignal.MOVING : PickSignal.NONE, before.handovers(), false));
        Answers answers = match == null || completes ? before.scene().silence()
                : before.scene().answers(act, open == null ? act : open);
        return new ActEffect(act, during, actReward(before, act), completes, open, answers,
                stalled == null ? 1 : pickRule.advance(), stalled);
    }

    // ---- BURLAP --------------------------------------------------------------------------------------------------

    /** The BURLAP domain; its chance comes from {@code random}, which BURLAP's threads must not share. */
    public PODomain generateDomain(RandomGenerator random) {
        PODomain domain = new PODomain();
        types().forEach(domain::addActionType);
        domain.setModel(new HandoverModel(this, random));
        domain.setObservationFunction(new HandoverObservationFunction(this, random));
        domain.setStateEnumerator(new StateEnumerator(domain, new ReflectiveHashableStateFactory()));
        return domain;
    }

    /** As BURLAP's own domains: chance from BURLAP's {@code RandomFactory} 0, which callers seed. */
    @Override
    public PODomain generateDomain() {
        return generateDomain(RandomFactory.getMapped(0));
    }

    /**
     * The states of {@link #generateDomain} that stand behind a wish and what is known, with their probabilities: in a
     * variant with more hidden variables more than one.
     */
    public Map<State, Double> hidden(HandoverState s) {
        return Map.of(s, 1.0);
    }

    /** The state in which a human who wants {@code wanted} starts. Throws if there is no such object. */
    public HandoverState initialState(String wanted) {
        int i = start().indexOf(wanted);
        if (i < 0) {
            throw new IllegalArgumentException(wanted + " is not on the table: " + start());
        }
        return new HandoverState(i, task(start()), Simplex.uniform(start().size()));
    }
}
