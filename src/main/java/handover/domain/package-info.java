/**
 * The problem in its own words: what is on the table, what the robot can do, what people do in reply, what it is worth;
 * and the same as BURLAP classes.
 *
 * <p>2026-11-22, where the human's answer lives. Whether the last question is still open decides what the next act means
 * (waiting, repeating), so it must be in the state; but it depends on what the human said, and in BURLAP a state is drawn
 * before its observation. So the transition draws the answer: {@link handover.domain.Task#answer()} is part of the next
 * state, and the observation shows it. The robot always knows it, so the belief still ranges over the wanted object only.
 * Rejected: to let the belief update close the reference behind the state's back, for then {@code FullModel} would not be
 * the process that {@code BeliefUpdate} filters.
 *
 * <p>2026-11-22, {@link handover.domain.ActEffect}. All that an act does apart from beliefs (task, price, who would answer
 * what) is one cached immutable value; transition model, observation function, filter, search and simulator read it, so
 * that none of them has a copy of a formula.
 *
 * <p>2026-11-22, a pick takes the floor. PICK neither becomes nor keeps an open reference: what is said while the robot
 * reaches is about the reach.
 *
 * <p>2026-11-22, misperception is a part of every domain, not of one. {@code perception} of the spec and the seam
 * {@link handover.domain.HandoverDomain#percepts} work with increments, communicated objects and variants of other people, and a
 * human file can have it; the variant {@code nested} is only a different default. Where the human may misperceive, a state holds a
 * second task, the one that they see: it has the reference that they take to be open, and its cached effects give answers,
 * contrast and annoyance without another formula. A misread act is taken for the act of its type that is most like it, so that an
 * update has three branches and not as many as there are acts. Rejected: a hidden flag "the last act was missed" (a question that
 * was missed must stay missed when it is answered later), and misperceived picks (the report calls them indisputable). The rates
 * of words and gestures follow the act that was done, so that a state need not remember what was perceived beyond what is open.
 */
package handover.domain;
