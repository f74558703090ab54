package handover.simulation;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.ActModel;
import handover.domain.HandoverDomain;
import handover.domain.Observation;
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
        Tally tally = new Tally(planner);
        while (!belief.task().done() && steps.size() < stepLimit) {
            HandoverBelief shown = solver.clairvoyant() ? belief.revealed(world.state().wanted()) : belief;
            tally.score(shown, world.state().wanted());
            long before = nanoClock.getAsLong();
            Decision decision = decide(index, shown, chance);
            nanos.add(nanoClock.getAsLong() - before);
            Step step = step(world, belief, decision.act());
            tally.add(step.act(), step.reward(), world.state().task().signal());
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
        HandoverBelief predicted = belief.after(act);
        double reward = world.step(act, predicted);
        Observation observation = world.react(act, planner.vocabulary());
        return new Step(act, observation, reward, predicted.given(observation));
    }
}
