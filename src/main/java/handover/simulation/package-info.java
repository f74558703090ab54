/**
 * Simulated people and episodes. A run is a function of its seed: nature (what is wanted), the human (what they say and
 * show) and the planner have streams of their own per episode, so that solvers meet the same people with the same luck, on
 * any number of threads.
 *
 * <p>2026-11-22, the reward of an episode is that of the states that really were: the match part is S(e_omega, h) with the
 * simulated human's own belief h. Its expectation is the planner's reward where the planner's model holds, and where it does
 * not hold nobody is paid for believing that they were understood. Belief-dependent scores exist only at belief level and
 * use the robot's b.
 */
package handover.simulation;
