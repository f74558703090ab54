package handover.simulation;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.ActModel;
import handover.domain.ActType;
import handover.domain.AskType;
import handover.domain.HandoverDomain;
import handover.domain.Observation;
import handover.domain.PickSignal;
import handover.domain.Speech;
import handover.domain.Utterance;
import handover.math.MatchScore;
import handover.math.Simplex;
import handover.math.Streams;
import handover.solver.Deadline;
import handover.solver.Decision;
import handover.solver.Policy;
import handover.solver.Solver;
import java.util.ArrayList;
import java.util.List;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import java.util.random.RandomGenerator;

/**
 * Plays episodes of one solver with simulated people. Episode k is a function of seed and k alone (but for the times that
 * decisions took, and for decisions under a deadline). Thread safe.
 */
public final class EpisodeRunner {
    /** Episodes end after so many steps unless told otherwise. */
    public static final int STEP_LIMIT = 100;

    private final HandoverDomain planner;
    private final HandoverDomain people;
    private final Solver solver;
    private final Policy policy;
    private final long seed;
    private final int stepLimit;
    private final Supplier<Deadline> deadlines;
    private final LongSupplier nanoClock;

    /**
     * @param planner what the robot thinks people are like
     * @param people what they are like; the same objects
     * @param deadlines gives the deadline of each decision when it starts
     * @param nanoClock for measuring decisions only
     */
    public EpisodeRunner(HandoverDomain planner, HandoverDomain people, Solver solver, long seed, int stepLimit,
            Supplier<Deadline> deadlines, LongSupplier nanoClock) {
        this.planner = planner;
        this.people = people;
        this.solver = solver;
        this.policy = solver.solve(planner, Streams.of(seed, "solve", 0));
        this.seed = seed;
        this.stepLimit = stepLimit;
        this.deadlines = deadlines;
        this.nanoClock = nanoClock;
    }

    /** Plays episode {@code index}. Throws {@link IllegalStateException} if the policy chooses what is not legal. */
    public Episode play(int index) {
        World world = new World(people, seed, index);
        RandomGenerator chance = Streams.of(seed, "planner", index);
        HandoverBelief start = HandoverBelief.initial(planner);
        HandoverBelief belief = start;
        String wanted = world.wanted();
        List<Step> steps = new ArrayList<>();
        List<Long> nanos = new ArrayList<>();
        Tally tally = new Tally();
        while (!belief.task().done() && steps.size() < stepLimit) {
            HandoverBelief shown = solver.clairvoyant() ? belief.revealed(world.state().wanted()) : belief;
            tally.score(shown, world.state().wanted());
            long before = nanoClock.getAsLong();
            Decision decision = decide(index, shown, chance);
            nanos.add(nanoClock.getAsLong() - before);
            Step step = step(world, belief, decision.act());
            tally.add(step, world.state().task().signal());
            steps.add(step);
            belief = step.belief();
        }
        return new Episode(index, solver.name(), wanted, start, List.copyOf(steps), tally.measures(belief),
                nanos.stream().mapToLong(n -> n).toArray());
    }

    private Decision decide(int index, HandoverBelief belief, RandomGenerator chance) {
        try {
            return policy.decide(belief, deadlines.get(), chance);
        } catch (RuntimeException e) {
            throw new IllegalStateException(solver.name() + " failed in episode " + index + ", at " + belief + ": " + e, e);
        }
    }

    private Step step(World world, HandoverBelief belief, Act act) {
        ActModel model = belief.scene().model(act);
        if (model == null) {
            throw new IllegalStateException(solver.name() + " chose " + act + ", which is not legal with "
                    + belief.scene() + " on the table");
        }
        double reward = world.step(act);
        HandoverBelief predicted = belief.after(act);
        if (planner.beliefDependentReward()) {
            double[] b = predicted.probabilities();
            reward += planner.matchReward(b, predicted.human(), b.length);
        }
        Observation observation = asHeardBy(planner, world.react(act));
        return new Step(act, observation, reward, predicted.given(observation));
    }

    /** Words that these people use but the planner's vocabulary lacks are unknown words to it. */
    private Observation asHeardBy(HandoverDomain listener, Observation o) {
        if (o.speech() == null || people.vocabulary().words().equals(listener.vocabulary().words())) {
            return o;
        }
        Utterance said = o.speech().alternatives().get(0).utterance();
        return new Observation(Speech.of(said.text(), listener.vocabulary()), o.gesture(), o.signal());
    }

    /** Adds up what an episode is worth. */
    private final class Tally {
        private Boolean firstPickRight;
        private double seconds;
        private double discountedReturn;
        private double discount = 1;
        private int steps;
        private int questions;
        private double logScore;
        private double brierScore;
        private double distance;

        void score(HandoverBelief belief, int wanted) {
            double[] b = belief.probabilities();
            double[] truth = Simplex.vertex(b.length, wanted);
            logScore += MatchScore.LOG.of(truth, b, b.length);
            brierScore += MatchScore.BRIER.of(truth, b, b.length);
            distance += Simplex.l1(b, belief.human());
        }

        void add(Step step, PickSignal signal) {
            if (firstPickRight == null && (signal == PickSignal.ACCEPTED || signal == PickSignal.REJECTED)) {
                firstPickRight = signal == PickSignal.ACCEPTED;
            }
            seconds += planner.seconds(typeOf(step.act()));
            discountedReturn += discount * step.reward();
            discount *= planner.discount();
            steps++;
            questions += step.act().verb().equals(AskType.VERB) ? 1 : 0;
        }

        private ActType typeOf(Act act) {
            return planner.types().stream().filter(t -> t.verb().equals(act.verb())).findFirst().orElseThrow();
        }

        Measures measures(HandoverBelief end) {
            int n = Math.max(1, steps);
            return new Measures(Boolean.TRUE.equals(firstPickRight), end.task().handovers() >= planner.spec().handovers(),
                    seconds, steps, discountedReturn, questions, logScore / n, brierScore / n, distance / n);
        }
    }
}
