/**
 * What the robot believes about the wanted object and how acts and observations move it: the exact filter of MODEL 4.4,
 * whole steps (simulator, search, BURLAP) and event by event (bridge, {@code infer}), the same posterior either way.
 *
 * <p>2026-11-22, log weights. A belief keeps log b beside b, so that an object which a long utterance made all but
 * impossible (b underflows to 0) can still come back.
 *
 * <p>2026-11-22, n-best lists. Alternatives that disagree about whether content words or an answer were said at all are
 * weighed as whole steps: the alternative without words pays 1 - P(content words). Words that come later in the same step
 * then no longer pay for having come at all.
 *
 * <p>2026-11-22, parts that nobody could have said. An answer when nothing is open, or content words that fit no object (with
 * the rate at which people speak), make only that part uninformative; the rest of the utterance still counts. By the letter of
 * MODEL 4.3 the whole observation would be dropped, but then a step heard at once and the same step heard event by event would
 * give different beliefs.
 *
 * <p>2026-11-22, minds. Where acts may be misperceived, the belief is over the wanted object and the human's mind together
 * (docs/theory.md, 9): an answer makes them dependent, and one Dirichlet cannot hold the two peaks of an act that may have been
 * missed. It is one code path: a base belief has one mind, and what it computes is what it computed before, to the last bit. Near
 * minds are put together by {@code handover.theory}, hence the arrow from here to there; a second copy of its clustering would have
 * been the alternative, and its {@code JointBelief} does not hold what the human takes to be open.
 */
package handover.belief;
