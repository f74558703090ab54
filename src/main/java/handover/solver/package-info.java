/**
 * Choosing acts: a {@link handover.solver.Solver} works offline and gives a {@link handover.solver.Policy}, which decides
 * online. Searches know of a problem only what {@link handover.solver.BeliefMdp} says.
 *
 * <p>2026-11-22, chance is handed to each decision. {@code decide(belief, deadline, random)} is a pure function of its
 * arguments, so policies have no state between decisions, may be shared by threads, and a replayed decision is the same
 * decision. Rejected: a generator inside the policy, whose state would depend on which decisions came before.
 *
 * <p>2026-11-22, pick outcomes are enumerated. Where an act completes a pick, the search weighs accepted and rejected by
 * their exact probabilities instead of sampling them: with 10 samples a 5% risk of -150 would otherwise be missed in 60%
 * of the estimates. Speech and gestures are sampled.
 */
package handover.solver;
