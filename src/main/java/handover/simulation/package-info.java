/**
 * Simulated people and episodes. A run is a function of its seed: nature (what is wanted), the human (what they say and
 * show) and the planner have streams of their own per episode, so that solvers meet the same people with the same luck, on
 * any number of threads.
 *
 * <p>2026-11-22, the reward of an episode is that of the states that really were: the match part is S(e_omega, h) with the
 * simulated human's own belief h. Its expectation is the planner's reward where the planner's model holds, and where it does
 * not hold nobody is paid for believing that they were understood. Belief-dependent scores exist only at belief level and
 * use the robot's b.
 *
 * <p>2026-11-22, timed episodes. What people do in reaction to an act is drawn as in the untimed simulator, from the same streams;
 * only the times are added, from streams of their own. So the likelihoods of the model stay exact, both simulators meet the same
 * people, and without delays they are equal to the last bit. People react once to each act, however long the robot then thinks:
 * thinking time belongs to the step of the act before, which has one observation. Rejected: people who speak up anew while the robot
 * thinks, because a step in which somebody may speak twice is not the model's, and silence would weigh too much.
 *
 * <p>2026-11-22, reactions that come after the next act started are weighed against that act, as a robot must that cannot know what
 * they are about; those that were said in time but are reported late go where they belong, and what followed is filtered again. So
 * a quick robot hears answers to questions that it has left behind: that is a cost of not waiting, and it is in the figures.
 *
 * <p>2026-11-22, late reports are the business of {@link handover.belief.Timeline}, for simulated people as for real ones. Within a step
 * it weighs what is sensed in the order in which it arrives, as MODEL 4.4 and the protocol say; the first answer of a step closes the
 * reference. Rejected: the order in which it was said, which the timed simulation used to sort by. It gives the same beliefs as long as
 * all sensors take equally long, as they do here, but a robot that is served while it listens cannot wait for what was said earlier.
 *
 * <p>2026-11-22, the concurrent agent plans as if the rest of the step stayed silent: for the belief with which the next act would start
 * if nothing more came. It plans anew at once if the belief moves by more than a threshold, also after the end of the act
 * ({@code patience}). That may cost a planning, but acting on what it knows to be out of date costs more: over 4,000 episodes with
 * incremental picks and 2 s of planning, a robot with patience was as quick as one without, and earned 1.4 more. Rejected: plans in store for each answer,
 * which cost a planning each, and planning at the open belief of the moment, at which no act will start.
 *
 * <p>2026-11-22, planning latency is a model (fixed, log-normal, beliefs visited), never a clock that was read, or the same seed
 * would give other episodes. A decision that is planned again draws the same numbers again, and the next decision those that it
 * would draw in the untimed simulator.
 */
package handover.simulation;
