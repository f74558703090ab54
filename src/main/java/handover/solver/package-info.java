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
 *
 * <p>2026-11-22, common random numbers and strata. The C samples of an act come from C equal parts of the distribution of
 * what is wanted, and the same numbers serve every act that is compared: with 10 samples the difference of two acts would
 * otherwise be off by more than most differences are.
 *
 * <p>2026-11-22, leaves. "Hand over now or wait for ever" values an undecided belief at -35 where a good planner gets +33, so
 * that a short search becomes timid; asking about one object after the other is as simple a policy, and its value can be
 * written down too. Where a pick takes increments, so is a reach that is broken off at a no. What a leaf is worth is the best of them.
 *
 * <p>2026-11-22, the anytime planner races acts. Measured by the loss of single decisions against POSS with hundreds of samples, what
 * costs POSS most is not its short horizon but its few samples: H=3, C=10 loses no less than H=2, C=10, and H=2, C=500 ten times less.
 * So draws go to the acts between which the choice is close, and only what is left is looked at deeper. A deeper race changes the
 * choice only if it is sure by a standard error. Rejected: best-first search by upper bounds (they come from being told what is
 * wanted, and lie 10 above a value of 35, so that nothing is ever left out), and deepening all acts.
 * With increments QMDP, which reaches at once and listens, earned 1 to 2 more than any search with these leaves. So the same is played
 * out in rollouts, and the planner takes their act where they earn more than looking ahead promises.
 *
 * <p>2026-11-22, precomputed policies. The metric is d^2 = H^2(b, b') + H^2(h, h') / 4 with the Hellinger distance: it tells
 * apart probabilities near certainty, where it is decided whether a pick is worth the risk, and it is Euclidean in square
 * roots, so that a k-d tree with bounding boxes finds exact neighbours. What does not match in the task, or in the hash of the
 * objects on the table, is not a neighbour at any distance.
 *
 * <p>2026-11-22, baselines. The rule of thumb and the greedy communicator hand over by the same rule, so that they differ in how
 * they communicate alone. "The expected pick value exceeds R+ discounted" is read as p R+ + (1 - p) R- &gt; gamma R+: better than to
 * be told within a step and to be right then. Rejected: to count the price of a pick, which both sides pay. QMDP knows what is wanted
 * from the next act on and then reaches for it, through all increments; with a wish that may move it follows it, which is exact
 * for the shipped kinds of picks but for people's reading of an increment that stalls. A random robot finishes a pick that it began,
 * or increments would make it harmless.
 *
 * <p>2026-11-22, a search of its own for minds. {@link handover.solver.NestedSearch} wraps the plain search, which keeps its speed,
 * and takes from it everything but the minds: picks, leaves, evidence. It draws the same numbers in the same order, so that with one
 * mind it is the plain search, which a test checks. It has no bounds. Leaves see E[beta], because simple policies do not depend on
 * the human's belief but by the small match reward.
 */
package handover.solver;
