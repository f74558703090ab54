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
 * under way. Exact Bayes filter of MODEL 4.4; every method that moves it returns a new belief. Immutable, thread safe;
 * arrays must not be modified.
 */
public final class HandoverBelief implements EnumerableBeliefState, HashableState {
    private static final List<Object> KEYS = List.of("belief", "humanBelief", "task");

    private final Task task;
    private final double[] log;
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

    private HandoverBelief(Task task, double[] log, double[] human, ActEffect step, Sensed sensed) {
        this.task = task;
        this.log = log;
        this.probabilities = LogWeights.exp(log);
        this.human = human;
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
        return new HandoverBelief(task, LogWeights.log(b), h.clone(), step, Sensed.NOTHING);
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

    /** h, one entry per object of the scene. */
    public double[] human() {
        return human;
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
        HandoverBelief before = closed();
        double tau = domain().spec().tau();
        double[] moved = before.log;
        if (tau != 1) {
            double[] p = before.probabilities.clone();
            Simplex.propagate(tau, p, p, p.length);
            moved = LogWeights.log(p);
        }
        return new HandoverBelief(effect.during(), moved, domain().understood(effect.model(), human), effect, Sensed.NOTHING);
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
        Weighing w = new Weighing(step, human, sensed.content, sensed.answer);
        double[] likelihood = w.logLikelihood(speech);
        Answer answer = sensed.answer ? Answer.NONE : w.answerable() ? speech.answer() : Answer.NONE;
        Task next = answer == Answer.NONE ? task : task.answered(answer);
        Sensed after = sensed.with(speech.mayHaveContent(), speech.mayHaveAnswer() && w.answerable(), w.uninformative());
        return correct(likelihood, next, after);
    }

    /** Corrects with one gesture. Throws {@link IllegalArgumentException} if its shoulder is at an object. */
    public HandoverBelief saw(Gesture gesture) {
        if (step == null || sensed.closed) {
            return sense(sensed.with(false, false, true));
        }
        return correct(HumanModel.logGestureDensities(scene(), gesture), task, sensed.with(false, false, false));
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
            after = log.clone();
            after[x] = Double.NEGATIVE_INFINITY;
            possible = Simplex.normaliseLog(after);
            after = possible ? after : LogWeights.log(LogWeights.excluding(x, log.length));
            after = n < after.length ? LogWeights.dropped(after, x) : after;
        }
        return new HandoverBelief(next, after, Simplex.uniform(n), n == 0 ? null : step.once(next),
                sensed.with(false, false, !possible));
    }

    /** The increment under way did not advance; does nothing if every increment surely does. */
    public HandoverBelief stalled() {
        ActEffect other = step == null ? null : step.stalled();
        return other == null ? this : new HandoverBelief(other.during(), log, human, other, sensed);
    }

    /** Gives up the pick under way; what the human saw of it stays. */
    public HandoverBelief cancelled() {
        return new HandoverBelief(task.cancelled(), log, human, step, sensed);
    }

    /** Corrects with what did not come in the step (MODEL 4.4), once. */
    public HandoverBelief closed() {
        if (step == null || sensed.closed) {
            return this;
        }
        Weighing w = new Weighing(step, human, sensed.content, sensed.answer);
        Sensed after = new Sensed(sensed.content, sensed.answer, true, false);
        return correct(w.logLikelihoodOfSilence(), task, after);
    }

    /** The same with certainty that the human wants object {@code i}. */
    public HandoverBelief revealed(int i) {
        return new HandoverBelief(task, LogWeights.log(Simplex.vertex(log.length, i)), human, step, sensed);
    }

    private HandoverBelief correct(double[] logLikelihood, Task next, Sensed after) {
        double[] posterior = log.clone();
        for (int i = 0; i < posterior.length; i++) {
            posterior[i] += logLikelihood[i];
        }
        boolean possible = Simplex.normaliseLog(posterior);
        return new HandoverBelief(next, possible ? posterior : log, human, step,
                possible ? after : after.with(false, false, true));
    }

    private HandoverBelief sense(Sensed after) {
        return new HandoverBelief(task, log, human, step, after);
    }

    // ---- BURLAP --------------------------------------------------------------------------------------------------

    @Override
    public double belief(State s) {
        HandoverState state = (HandoverState) s;
        boolean same = state.task().equals(task) && Arrays.equals(state.human(), human);
        return !same ? 0 : state.wanted() < 0 ? 1 : probabilities[state.wanted()];
    }

    @Override
    public List<StateBelief> nonZeroBeliefs() {
        List<StateBelief> all = new ArrayList<>();
        for (int i = 0; i < probabilities.length; i++) {
            if (probabilities[i] > 0) {
                all.add(new StateBelief(new HandoverState(i, task, human), probabilities[i]));
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
        int i = Simplex.sample(probabilities, probabilities.length, RandomFactory.getMapped(0));
        return new HandoverState(i, task, human);
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
        return o instanceof HandoverBelief b && task.equals(b.task) && Arrays.equals(log, b.log)
                && Arrays.equals(human, b.human) && sensed.equals(b.sensed) && underWay().equals(b.underWay());
    }

    private Act underWay() {
        return step == null ? Act.WAIT : step.model().act();
    }

    @Override
    public int hashCode() {
        return 31 * (31 * task.hashCode() + Arrays.hashCode(log)) + Arrays.hashCode(human);
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
