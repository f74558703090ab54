package handover.belief;

import burlap.debugtools.RandomFactory;
import burlap.mdp.core.state.State;
import burlap.mdp.singleagent.pomdp.beliefstate.EnumerableBeliefState;
import burlap.statehashing.HashableState;
import handover.domain.Act;
import handover.domain.ActEffect;
import handover.domain.Answer;
import handover.domain.Gesture;
import handover.domain.HandoverDomain;
import handover.domain.HandoverState;
import handover.domain.HumanModel;
import handover.domain.Observation;
import handover.domain.PickSignal;
import handover.domain.Scene;
import handover.domain.Speech;
import handover.domain.Task;
import handover.math.Simplex;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/**
 * What the robot knows and believes: b over the wanted object, h, the task, and what was sensed so far in the step that is
 * under way. Exact Bayes filter of MODEL 4.4; every method that moves it returns a new belief. Where the human may misperceive
 * acts (MODEL 8) it is a belief over the wanted object and the human's {@link Mind} together, exact up to
 * {@code perception.minds} of them. Immutable, thread safe; arrays must not be modified.
 */
public final class HandoverBelief implements EnumerableBeliefState, HashableState {
    private static final List<Object> KEYS = List.of("belief", "humanBelief", "task");

    private final Task task;
    private final List<Mind> minds;
    private final double[] probabilities;
    private final double[] human;
    /** The act under way; null on an empty table. */
    private final ActEffect step;
    private final Sensed sensed;

    /** What is already accounted for in the step under way, and whether the last update told nothing. */
    private record Sensed(boolean content, boolean answer, boolean closed, boolean uninformative) {
        static final Sensed NOTHING = new Sensed(false, false, false, false);

        Sensed with(boolean more, boolean answered, boolean uninformative) {
            return new Sensed(content || more, answer || answered, closed, uninformative);
        }
    }

    private HandoverBelief(Task task, List<Mind> minds, ActEffect step, Sensed sensed) {
        this.task = task;
        this.minds = minds;
        this.probabilities = LogWeights.exp(Minds.marginal(minds));
        this.human = Minds.mean(minds);
        this.step = step;
        this.sensed = sensed;
    }

    /** b_0 and h_0 at the start of an episode: the step before the first act, a WAIT without reference. */
    public static HandoverBelief initial(HandoverDomain domain) {
        return of(domain.task(domain.start()), domain.prior(domain.start()), Simplex.uniform(domain.start().size()));
    }

    /**
     * A given belief at the beginning of a WAIT without new evidence.
     *
     * @param b over the objects of the task's scene, summing to one; copied
     * @param h likewise; copied
     */
    public static HandoverBelief of(Task task, double[] b, double[] h) {
        ActEffect step = task.done() || task.scene().size() == 0 ? null : task.effect(Act.WAIT);
        return new HandoverBelief(task, List.of(new Mind(task, step, h.clone(), LogWeights.log(b))), step, Sensed.NOTHING);
    }

    // ---- reading -------------------------------------------------------------------------------------------------

    public HandoverDomain domain() {
        return task.scene().domain();
    }

    public Task task() {
        return task;
    }

    public Scene scene() {
        return task.scene();
    }

    /** b, one entry per object of the scene. */
    public double[] probabilities() {
        return probabilities;
    }

    /** h, one entry per object of the scene; its expectation where it is uncertain. */
    public double[] human() {
        return human;
    }

    /** What the human may believe and think to be open; one mind where acts are perceived exactly. */
    public List<Mind> minds() {
        return minds;
    }

    /** At most {@code limit} minds that stand for all, with the same b and the same expectation of h. */
    public List<Mind> minds(int limit) {
        return Minds.merged(minds, limit);
    }

    /** The expected match reward of MODEL 6 for an act that has just started. */
    public double matchReward() {
        HandoverDomain domain = domain();
        int n = human.length;
        if (minds.size() == 1) {
            return domain.matchReward(probabilities, human, n);
        }
        double sum = 0;
        for (Mind m : minds) {
            double[] b = domain.beliefDependentReward() ? probabilities : LogWeights.given(m.log());
            sum += m.weight() * domain.matchReward(b, m.human(), n);
        }
        return sum;
    }

    /** Whether what was sensed last (or its absence) had likelihood 0 for every object and was left out (MODEL 4.3). */
    public boolean uninformative() {
        return sensed.uninformative;
    }

    /** Whether a pick completes in this step and its outcome is not known yet. */
    public boolean pickPending() {
        return step != null && step.completes() && task == step.during();
    }

    // ---- moving --------------------------------------------------------------------------------------------------

    /**
     * Predicts: closes the step under way and starts an act (MODEL 4.4: transition of omega, update of h).
     * Throws {@link IllegalArgumentException} if the act is not legal.
     */
    public HandoverBelief after(Act act) {
        ActEffect effect = task.effect(act);
        return new HandoverBelief(effect.during(), Minds.after(closed().minds, scene(), effect.model()), effect, Sensed.NOTHING);
    }

    /**
     * Corrects with everything that was sensed in the step, and closes the step.
     * Throws {@link IllegalArgumentException} if a pick completes but the observation does not say how.
     */
    public HandoverBelief given(Observation o) {
        HandoverBelief b = o.signal() == PickSignal.NONE ? stalled() : this;
        if (b.pickPending()) {
            if (o.signal() != PickSignal.ACCEPTED && o.signal() != PickSignal.REJECTED) {
                throw new IllegalArgumentException("the pick of " + task.target()
                        + " completes in this step: expected the signal ACCEPTED or REJECTED, got " + o.signal());
            }
            b = b.picked(o.signal() == PickSignal.ACCEPTED);
        }
        boolean uninformative = b.uninformative();
        if (o.speech() != null) {
            b = b.heard(o.speech());
            uninformative |= b.uninformative();
        }
        if (o.gesture() != null) {
            b = b.saw(o.gesture());
            uninformative |= b.uninformative();
        }
        b = b.closed();
        return b.sense(b.sensed.with(false, false, uninformative || b.uninformative()));
    }

    /** Corrects with one utterance. */
    public HandoverBelief heard(Speech speech) {
        if (step == null || sensed.closed) {
            return sense(sensed.with(false, false, true));
        }
        Weighing w = weighing();
        double[][] likelihood = w.logLikelihood(speech);
        Answer answer = sensed.answer ? Answer.NONE : w.answerable() ? speech.answer() : Answer.NONE;
        Sensed after = sensed.with(speech.mayHaveContent(), speech.mayHaveAnswer() && w.answerable(), w.uninformative());
        return correct(likelihood, answer, after);
    }

    private Weighing weighing() {
        return new Weighing(step.during().scene(), step.model().type(), minds, sensed.content, sensed.answer);
    }

    /** Corrects with one gesture. Throws {@link IllegalArgumentException} if its shoulder is at an object. */
    public HandoverBelief saw(Gesture gesture) {
        if (step == null || sensed.closed) {
            return sense(sensed.with(false, false, true));
        }
        double[][] likelihood = new double[minds.size()][];
        Arrays.fill(likelihood, HumanModel.logGestureDensities(scene(), gesture));
        return correct(likelihood, Answer.NONE, sensed.with(false, false, false));
    }

    /**
     * Corrects with the outcome of the pick under way (MODEL 5): the next wish, or the knowledge that this was not it.
     * Throws {@link IllegalStateException} if no pick is under way.
     */
    public HandoverBelief picked(boolean accepted) {
        if (task.target() == null) {
            throw new IllegalStateException("no pick is under way");
        }
        int x = scene().indexOf(task.target());
        Task next = task.completed(accepted);
        int n = next.scene().size();
        boolean possible = true;
        double[] after = LogWeights.log(Simplex.uniform(n));
        if (!accepted) {
            after = Minds.marginal(minds).clone();
            after[x] = Double.NEGATIVE_INFINITY;
            possible = Simplex.normaliseLog(after);
            after = possible ? after : LogWeights.log(LogWeights.excluding(x, after.length));
            after = n < after.length ? LogWeights.dropped(after, x) : after;
        }
        ActEffect once = n == 0 ? null : step.once(next);
        return new HandoverBelief(next, List.of(new Mind(next, once, Simplex.uniform(n), after)), once,
                sensed.with(false, false, !possible));
    }

    /** The increment under way did not advance; does nothing if every increment surely does. */
    public HandoverBelief stalled() {
        ActEffect other = step == null ? null : step.stalled();
        return other == null ? this : new HandoverBelief(other.during(), minds.stream().map(m -> {
            ActEffect seen = m.step().stalled();
            return new Mind(seen.during(), seen, m.human(), m.log());
        }).toList(), other, sensed);
    }

    /** Gives up the pick under way; what the human saw of it stays. */
    public HandoverBelief cancelled() {
        return new HandoverBelief(task.cancelled(), minds.stream().map(m -> m.seeing(m.task().cancelled())).toList(), step, sensed);
    }

    /** Corrects with what did not come in the step (MODEL 4.4), once. */
    public HandoverBelief closed() {
        if (step == null || sensed.closed) {
            return this;
        }
        Sensed after = new Sensed(sensed.content, sensed.answer, true, false);
        HandoverBelief b = correct(weighing().logLikelihoodOfSilence(), Answer.NONE, after);
        return minds.size() == 1 ? b
                : new HandoverBelief(b.task, Minds.merged(b.minds, domain().spec().perception().minds()), step, b.sensed);
    }

    /** The same with certainty that the human wants object {@code i}. */
    public HandoverBelief revealed(int i) {
        return new HandoverBelief(task, Minds.revealed(minds, i), step, sensed);
    }

    /**
     * The same belief about another table. What is still there keeps its share among what was there; what was added gets the
     * share of one object among all, 1 / N, as if nothing had been sensed yet.
     *
     * @param other with at least one object
     */
    public HandoverBelief on(Scene other) {
        int[] before = other.objects().stream().mapToInt(o -> scene().indexOf(o.name())).toArray();
        ActEffect rest = step == null || step.during().done() ? null : step.on(other);
        return new HandoverBelief(task.on(other), Minds.on(minds, other, before, rest), rest, sensed);
    }

    private HandoverBelief correct(double[][] logLikelihood, Answer answer, Sensed after) {
        List<Mind> posterior = Minds.corrected(minds, logLikelihood);
        List<Mind> next = posterior == null ? minds : posterior;
        boolean answered = answer != Answer.NONE;
        return new HandoverBelief(answered ? task.answered(answer) : task,
                answered ? next.stream().map(m -> m.seeing(m.task().answered(answer))).toList() : next, step,
                posterior == null ? after.with(false, false, true) : after);
    }

    private HandoverBelief sense(Sensed after) {
        return new HandoverBelief(task, minds, step, after);
    }

    // ---- BURLAP --------------------------------------------------------------------------------------------------

    @Override
    public double belief(State s) {
        HandoverState state = (HandoverState) s;
        int i = state.wanted();
        return !state.task().equals(task) ? 0 : minds.stream()
                .filter(m -> m.task().settled().equals(state.seen().settled()) && Arrays.equals(state.human(), m.human()))
                .mapToDouble(m -> i < 0 ? 1 : minds.size() == 1 ? probabilities[i] : Math.exp(m.log()[i])).sum();
    }

    @Override
    public List<StateBelief> nonZeroBeliefs() {
        List<StateBelief> all = new ArrayList<>();
        for (Mind m : minds) {
            for (int i = 0; i < probabilities.length; i++) {
                double p = minds.size() == 1 ? probabilities[i] : Math.exp(m.log()[i]);
                if (p > 0) {
                    all.add(new StateBelief(new HandoverState(i, task, m.human(), m.task()), p));
                }
            }
        }
        if (all.isEmpty()) {
            all.add(new StateBelief(new HandoverState(-1, task, human), 1));
        }
        return all;
    }

    /** A state, drawn by BURLAP's {@code RandomFactory} 0 as its callers expect. */
    @Override
    public HandoverState sample() {
        List<StateBelief> states = nonZeroBeliefs();
        double[] p = states.stream().mapToDouble(s -> s.belief).toArray();
        return (HandoverState) states.get(Math.max(0, Simplex.sample(p, p.length, RandomFactory.getMapped(0)))).s;
    }

    @Override
    public List<Object> variableKeys() {
        return KEYS;
    }

    @Override
    public Object get(Object key) {
        return switch (String.valueOf(key)) {
            case "belief" -> probabilities;
            case "humanBelief" -> human;
            case "task" -> task;
            default -> throw new IllegalArgumentException("a belief has the variables " + KEYS + ", not " + key);
        };
    }

    @Override
    public HandoverBelief copy() {
        return this;
    }

    @Override
    public State s() {
        return this;
    }

    @Override
    public boolean equals(Object o) {
        return o instanceof HandoverBelief b && task.equals(b.task) && minds.equals(b.minds)
                && sensed.equals(b.sensed) && underWay().equals(b.underWay());
    }

    private Act underWay() {
        return step == null ? Act.WAIT : step.model().act();
    }

    @Override
    public int hashCode() {
        return 31 * task.hashCode() + minds.hashCode();
    }

    /** {@code red_ball 0.91 (human expects 0.40), ...}. */
    @Override
    public String toString() {
        List<String> parts = new ArrayList<>();
        for (int i = 0; i < probabilities.length; i++) {
            parts.add(String.format(Locale.ROOT, "%s %.3f (human expects %.3f)", scene().objects().get(i).name(), probabilities[i],
                    human[i]));
        }
        return String.join(", ", parts);
    }
}
