/**
 * POMDPs with finitely many states, acts and observations, whatever they are about: the model as flat arrays, solvers with bounds, and
 * handover domains cut into such models.
 *
 * <p>2026-11-22, a package of its own. These solvers know nothing of handovers and their beliefs are plain arrays; {@code solver} knows
 * nothing of tables. What they share (deadlines, sparse sampling, the syntax of specifications) is in {@code solver}.
 *
 * <p>2026-11-22, trials of two kinds. HSVI's trials, by the widest gap, raise the lower bound slowly where many acts look alike from above:
 * on a flat model of 7 states, 25 acts and 253 observations the lower bound stood at 22 of 33 after 0.2 s of processor time, at 25 after 3 s.
 * With four of five trials drawn from the model under the best policy so far it stands at 32.4 after 0.2 s, and the upper bound is as
 * low. Rejected after measuring: acts by the mean of both bounds, other shares of the gap, following the policy to the widest gap,
 * pruning of vectors that a later one covers (few are).
 *
 * <p>2026-11-22, the sawtooth is projected onto a belief when a trial comes by, not when it is met first: three of five
 * beliefs are never looked at again, and projecting took half of the time.
 *
 * <p>2026-11-22, a decision starts from what was learnt offline. What a search at the start of the episode learns (vectors that hold at all
 * beliefs, upper bounds at some) makes the online search better from its first millisecond; decisions stay pure functions because
 * none of them adds to it. The offline work is counted in beliefs, not in seconds, so that it is the same on any machine.
 *
 * <p>2026-11-22, unforeseen observations. An observation of probability 0 leaves the predicted belief as it is and is counted. Rejected: to
 * start again from the uniform belief, which forgets what is known and hides that the model is wrong.
 */
package handover.tabular;
