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
 */
package handover.domain;
