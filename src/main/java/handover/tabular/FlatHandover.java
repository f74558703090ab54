package handover.tabular;

import burlap.mdp.core.action.Action;
import burlap.mdp.singleagent.model.TransitionProb;
import handover.domain.Act;
import handover.domain.ActModel;
import handover.domain.ActType;
import handover.domain.Answer;
import handover.domain.HandoverDomain;
import handover.domain.HandoverModel;
import handover.domain.HandoverState;
import handover.domain.Observation;
import handover.domain.PickSignal;
import handover.domain.Scene;
import handover.domain.Task;
import handover.domain.Utterance;
import handover.domain.Words;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.SplittableRandom;

/**
 * A handover domain with everything continuous cut into pieces, as a {@link TabularPomdp}. A state is what the human wants together
 * with a piece of what is known ({@link KnownPart}); an observation is the answer, the first content word (words that no object tells
 * apart are one) and the nearest object of the gesture ({@link GestureSectors}), and the pick signal. All numbers are the domain's:
 * {@link HandoverModel} for what happens and what it earns, the content rates, word tables and gesture densities for what is sensed.
 * Immutable, thread safe.
 */
public final class FlatHandover {
    /** States that a flat model may have. */
    private static final int MOST_STATES = 20_000;
    private static final String OVER = "over";

    /** How much of what is known is kept. */
    public enum Detail {
        /** Only what is wanted and how far a pick is: the human expects nothing in particular and no question stays open. */
        WISH,
        /** Also the open reference, with the human's belief as if nothing had been before it. */
        REFERENCE,
        /** Also the human's belief, up to a tolerance. */
        EXPECTATION
    }

    private final HandoverDomain domain;
    private final Detail detail;
    private final double tolerance;
    private final List<Act> acts;
    private final KnownPart.Parts parts;
    private final WordClasses words;
    private final Map<Scene, GestureSectors> sectors = new HashMap<>();
    private final Map<Sight, Integer> observations = new LinkedHashMap<>();
    private final List<HandoverState> states = new ArrayList<>();
    private final Map<List<Integer>, Integer> stateOf = new HashMap<>();
    private final TabularPomdp pomdp;

    /**
     * What the flat model distinguishes of an observation.
     *
     * @param word number of a word class, -1 for none
     * @param sector name of the nearest object, null for no gesture
     */
    private record Sight(Answer answer, int word, String sector, PickSignal signal) {}

    /** Where an act may lead, with which tasks behind the flat state. */
    private record Arrival(int act, int state) {}

    /**
     * Makes the flat model.
     *
     * @param tolerance L1 distance up to which beliefs of the human are one, for {@link Detail#EXPECTATION}; at least 0
     * @throws IllegalArgumentException if it would be too large
     */
    public FlatHandover(HandoverDomain domain, Detail detail, double tolerance) {
        this.domain = domain;
        this.detail = detail;
        this.tolerance = detail == Detail.EXPECTATION ? tolerance : 2;
        this.acts = domain.start().acts().stream().map(ActModel::act).toList();
        this.parts = new KnownPart.Parts(domain, detail, this.tolerance);
        this.words = new WordClasses(domain);
        this.pomdp = flatten();
    }

    public TabularPomdp pomdp() {
        return pomdp;
    }

    /** What was cut into which pieces, as lines for people. */
    public List<String> notes() {
        List<String> lines = new ArrayList<>();
        lines.add("The handover domain " + domain.spec().name() + " (" + domain.spec().variant() + "), flattened:");
        lines.add("states: the wanted object" + switch (detail) {
            case WISH -> " and how far a pick is; the person expects nothing in particular, questions do not stay open";
            case REFERENCE -> ", how far a pick is, and the open reference; what the person expects follows from that alone";
            case EXPECTATION -> ", how far a pick is, the open reference, and what the person expects, merged up to an L1 distance of "
                    + tolerance;
        } + "; " + OVER + " is the end");
        lines.add("observations: the answer, the first content word, the object that a gesture points at most nearly, the pick signal");
        if (!words.merged().isEmpty()) {
            lines.add("words that no object tells apart are one: " + String.join(", ", words.merged()));
        }
        lines.add("gesture probabilities are densities integrated over all directions that are nearest to one object");
        if (domain.beliefDependentReward()) {
            lines.add("the match reward depends on the belief, which this format cannot say: left out");
        }
        if (domain.spec().handovers() > 1) {
            lines.add("acts about objects that are gone are as WAIT");
        }
        return lines;
    }

    /** The number of an act. Throws {@link IllegalArgumentException} if it is not on offer at the start. */
    public int act(Act act) {
        int a = acts.indexOf(act);
        if (a < 0) {
            throw new IllegalArgumentException(act + " is not on offer at the start");
        }
        return a;
    }

    /** The number of the state in which an object is wanted at the start. */
    public int startState(int wanted) {
        return stateOf.get(List.of(wanted, 0));
    }

    /**
     * The number of the observation that an observation at the first table falls into.
     *
     * @throws IllegalArgumentException if it never can be observed in the flat model
     */
    public int observation(Observation o) {
        Utterance said = o.speech() == null ? Utterance.SILENCE : o.speech().alternatives().get(0).utterance();
        int word = said.content().isEmpty() ? -1 : words.of(said.content().get(0));
        GestureSectors at = sectors.get(domain.start());
        String sector = o.gesture() == null ? null : domain.start().objects().get(at.sector(o.gesture().direction())).name();
        Integer number = observations.get(new Sight(said.answer(), word, sector, o.signal()));
        if (number == null) {
            throw new IllegalArgumentException("expected an observation that can be, got " + o);
        }
        return number;
    }

    private TabularPomdp flatten() {
        List<Map<Integer, Double>> transitions = new ArrayList<>();
        List<Double> rewards = new ArrayList<>();
        Map<Arrival, Map<HandoverState, Double>> arrivals = new LinkedHashMap<>();
        double[] prior = domain.prior(domain.start());
        for (int i = 0; i < prior.length; i++) {
            state(new HandoverState(i, parts.get(0).task(), parts.get(0).human()));
        }
        HandoverModel model = new HandoverModel(domain, new SplittableRandom(0));
        for (int s = 0; s < states.size(); s++) {
            for (int a = 0; a < acts.size(); a++) {
                Map<Integer, Double> next = new LinkedHashMap<>();
                rewards.add(add(model, s, a, next, arrivals));
                transitions.add(next);
            }
        }
        arrivals.values().forEach(behind -> behind.keySet().forEach(s -> sights(s, acts.get(0)).keySet()
                .forEach(x -> observations.putIfAbsent(x, observations.size()))));
        return build(prior, transitions, rewards, arrivals);
    }

    private double add(HandoverModel model, int s, int a, Map<Integer, Double> next,
            Map<Arrival, Map<HandoverState, Double>> arrivals) {
        HandoverState from = states.get(s);
        if (from.task().done()) {
            next.put(s, 1.0);
            arrivals.computeIfAbsent(new Arrival(a, s), k -> new LinkedHashMap<>()).put(from, 1.0);
            return 0;
        }
        double reward = 0;
        for (TransitionProb t : model.transitions(from, legal(from, a))) {
            HandoverState to = (HandoverState) t.eo.op;
            int flat = state(to);
            reward += t.p * t.eo.r;
            next.merge(flat, t.p, Double::sum);
            HandoverState behind = new HandoverState(to.wanted(), to.task(), states.get(flat).human());
            arrivals.computeIfAbsent(new Arrival(a, flat), k -> new LinkedHashMap<>()).merge(behind, t.p, Double::sum);
        }
        return reward;
    }

    private Action legal(HandoverState from, int a) {
        return from.task().scene().model(acts.get(a)) == null ? Act.WAIT : acts.get(a);
    }

    /** The flat state that a state is merged into. */
    private int state(HandoverState s) {
        KnownPart part = s.task().done() ? null : parts.of(s);
        List<Integer> key = part == null ? List.of() : List.of(s.wanted(), part.number());
        Integer number = stateOf.get(key);
        if (number == null) {
            number = states.size();
            stateOf.put(key, number);
            states.add(part == null ? s : new HandoverState(s.wanted(), part.task(), part.human()));
            if (number >= MOST_STATES) {
                throw new IllegalArgumentException("expected at most " + MOST_STATES
                        + " states, got more: keep less of what is known, or merge more");
            }
        }
        return number;
    }

    /** What may be sensed in a state after an act, with its probability. */
    private Map<Sight, Double> sights(HandoverState s, Act act) {
        Task task = s.task();
        Map<Sight, Double> all = new LinkedHashMap<>();
        if (task.done()) {
            all.put(new Sight(Answer.NONE, -1, null, PickSignal.ACCEPTED), 1.0);
            return all;
        }
        Scene scene = task.scene();
        ActType type = type(act);
        double speaks = domain.contentRate(type, s.human()[s.wanted()]);
        double points = type.parameters().gestureRate();
        Words table = scene.words(task.reference() == null ? null : scene.model(task.reference()));
        double[] word = words.probabilities(table, s.wanted());
        GestureSectors at = sectors.computeIfAbsent(scene, GestureSectors::new);
        for (int w = -1; w < word.length; w++) {
            double said = w < 0 ? 1 - speaks : speaks * word[w];
            for (int j = -1; j < scene.size(); j++) {
                double shown = j < 0 ? 1 - points : points * at.probability(s.wanted(), j);
                all.put(new Sight(task.answer(), w, j < 0 ? null : scene.objects().get(j).name(), task.signal()), said * shown);
            }
        }
        return all;
    }

    private ActType type(Act act) {
        return domain.types().stream().filter(t -> t.verb().equals(act.verb())).findFirst().orElseThrow();
    }

    private TabularPomdp build(double[] prior, List<Map<Integer, Double>> transitions, List<Double> rewards,
            Map<Arrival, Map<HandoverState, Double>> arrivals) {
        TabularBuilder to = new TabularBuilder(domain.discount(), Names.of(states.stream().map(this::label).toList()),
                Names.of(acts), Names.of(observations.keySet().stream().map(this::label).toList()));
        to.start(Arrays.copyOf(prior, states.size()));
        for (int s = 0; s < states.size(); s++) {
            for (int a = 0; a < acts.size(); a++) {
                int act = a;
                int from = s;
                transitions.get(s * acts.size() + a).forEach((next, p) -> to.transition(act, from, next, p));
                to.reward(a, s, -1, -1, rewards.get(s * acts.size() + a));
                senses(to, a, s, arrivals);
            }
        }
        return to.build();
    }

    /** Where an act never leads, what would be sensed is taken from another act that leads there. */
    private void senses(TabularBuilder to, int a, int s, Map<Arrival, Map<HandoverState, Double>> arrivals) {
        int source = a;
        for (int k = 0; k < acts.size() && !arrivals.containsKey(new Arrival(source, s)); k++) {
            source = k;
        }
        Map<HandoverState, Double> behind = arrivals.getOrDefault(new Arrival(source, s), Map.of());
        if (behind.isEmpty()) {
            to.observation(a, s, 0, 1);
            return;
        }
        double total = behind.values().stream().mapToDouble(p -> p).sum();
        Act act = acts.get(source);
        behind.forEach((state, p) -> sights(state, act).forEach((sight, q) -> {
            int o = observations.get(sight);
            to.observation(a, s, o, to.observation(a, s, o) + p / total * q);
        }));
    }

    private String label(HandoverState s) {
        return s.task().done() ? OVER : s.task().scene().objects().get(s.wanted()).name() + parts.of(s).label();
    }

    private String label(Sight x) {
        List<String> said = new ArrayList<>();
        if (x.signal != PickSignal.NONE) {
            said.add(x.signal.name().toLowerCase(Locale.ROOT));
        }
        if (x.answer != Answer.NONE) {
            said.add(x.answer.name().toLowerCase(Locale.ROOT));
        }
        if (x.word >= 0) {
            said.add(words.name(x.word));
        }
        if (x.sector != null) {
            said.add("at-" + x.sector);
        }
        return said.isEmpty() ? "nothing" : String.join("-", said);
    }
}
