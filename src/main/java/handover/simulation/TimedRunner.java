package handover.simulation;

import handover.domain.HandoverDomain;
import handover.math.Streams;
import handover.solver.Policy;
import handover.solver.Solver;
import java.util.random.RandomGenerator;

/**
 * Plays episodes on a virtual clock, on which acting, reacting and thinking take time. Episode k of an agent is a function of
 * seed and k alone; people have the luck that they have in {@link EpisodeRunner}, and both agents meet the same people. Thread
 * safe.
 *
 * <p>The robot acts; when it decides depends on the {@link Agent}:
 * <ul>
 * <li>sequential: when the act is over it stops observing, plans on what it believes then, notices what came meanwhile,
 *     and does what it planned;
 * <li>concurrent: while an act runs it plans the next one as if nothing more came, and again when the belief changed: at once if
 *     {@link handover.solver.Replan} says so, else when it is through. When the act is over it does what it planned last, unless that is out of
 *     date; then it waits for the plan that is being made.
 * </ul>
 */
public final class TimedRunner {
    private final HandoverDomain planner;
    private final HandoverDomain people;
    private final Solver solver;
    private final Policy policy;
    private final long seed;
    private final int stepLimit;
    private final Timing timing;

    /**
     * @param planner what the robot thinks people are like
     * @param people what they are like; the same objects
     * @param stepLimit at which episodes end, at least 1
     */
    public TimedRunner(HandoverDomain planner, HandoverDomain people, Solver solver, long seed, int stepLimit, Timing timing) {
        this.planner = planner;
        this.people = people;
        this.solver = solver;
        this.policy = solver.solve(planner, Streams.of(seed, "solve", 0));
        this.seed = seed;
        this.stepLimit = stepLimit;
        this.timing = timing;
    }

    /** Plays episode {@code index}. Throws {@link IllegalStateException} if the policy chooses what is not legal. */
    public TimedEpisode play(int index, Agent agent) {
        return new TimedPlay(this, index, agent).play();
    }

    HandoverDomain planner() {
        return planner;
    }

    Solver solver() {
        return solver;
    }

    Policy policy() {
        return policy;
    }

    int stepLimit() {
        return stepLimit;
    }

    Timing timing() {
        return timing;
    }

    World world(int index) {
        return new World(people, seed, index);
    }

    PlannerChance chance(int index) {
        return new PlannerChance(() -> Streams.of(seed, "planner", index));
    }

    /** The luck of one step with times: the same whatever happened in the steps before. */
    RandomGenerator times(String role, int index, int step) {
        return Streams.of(seed, role, Streams.mix(index, step));
    }
}
