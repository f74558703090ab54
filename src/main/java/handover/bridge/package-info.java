/**
 * Serving decisions to a robot over ZeroMQ, and following an episode message by message.
 * {@link handover.bridge.Session} applies messages to the belief and knows nothing of sockets, threads or clocks;
 * {@link handover.bridge.Bridge} has the sockets.
 *
 * <p>2026-11-22, threads. One thread owns all sockets and the session, and publishes each belief as an immutable snapshot through
 * one volatile; planners only read it, and hand their plans over through a queue, ringing an inproc socket that the loop polls.
 * The loop has its own timer: a solver that does not heed its deadline is left behind (up to four of them) and the robot gets
 * WAIT. Rejected: a thread for each socket, which would need locks around the belief and would lose the order of arrival.
 *
 * <p>2026-11-22, planning again. The belief is compared while the policy works, not only afterwards, because a policy that uses
 * all of its time would never be asked again. What is said is heard until a tenth of the limit (at most 200 ms) is left: a short
 * plan for what is believed now is worth more than a long one for what is not. A run is broken off for that only after a
 * twentieth of the limit, and there are at most 20, so that a belief that never rests still gets a plan. The newest plan wins; that
 * of an earlier belief is answered if the solver does not return from a later one. What was planned for another episode, other
 * objects or before the robot's last act is never answered: it is planned again to the very end, then it is WAIT. Objects that
 * only moved, as they do with every frame of a tracker, are no reason to wait: {@code target} is where the object is now.
 * Rejected: to plan again only with as much time left as was spent, which is deaf for the second half of every limit.
 *
 * <p>2026-11-22, what is warm. Kept between runs are what was compiled for the table (acts, words, answers, what leaves are worth),
 * the likelihoods of gestures that were drawn in advance, and the nodes of the search, so that nothing is allocated anew. A table on
 * which anything moved is another table; its likelihoods are drawn anew. Not kept are values and draws of the tree: they are of
 * another belief, and a value at one belief is no value at another; to start from them would bias a short plan towards the act
 * that was just found out of date.
 *
 * <p>2026-11-22, {@code simulate --timed} judges by the same {@link handover.solver.Replan} whether a plan is out of date. It has no limit
 * to share out, so it starts anew at once; a robot there waits for a plan up to its patience, one here gets an answer at its deadline.
 *
 * <p>2026-11-22, late observations. What was sensed before the last act is weighed by computing the belief again from the act
 * before which it belongs ({@link handover.belief.Timeline}); this equals what would be believed had it come in time. A {@code t}
 * in the future counts as now, and when the clock is set back the times of earlier acts are forgotten: a clock that is wrong
 * must not make everything stale.
 *
 * <p>2026-11-22, what waits. A message of the stream came when it was taken off the socket, not when its turn came: that is its
 * {@code t} if it has none, and its age is measured then. So the stream is taken, unread, before the commands are. Only if the
 * clock was set back is seen by the times at which messages are applied; the log has both times. Rejected: to apply all that
 * waits before an {@code acted}, which would keep the robot waiting for as long.
 *
 * <p>2026-11-22, the table. An object that was added gets 1/N of b and h, the others share the rest as before: nothing was sensed
 * yet that speaks for or against it. What was reported by {@code scene} also holds for the next episode, and what was handed over
 * is then back; earlier only if it is {@code added}, because trackers go on to report an object in somebody's hand. V stays that of the domain file (MODEL 4.1), so words that only an added object has are unknown.
 *
 * <p>2026-11-22, the stream. Messages are decoded when they are read, so that gestures and unfinal speech can give way, the
 * oldest first, when too many wait. What must not be lost is never dropped; if nothing else is left to drop it is refused with
 * {@code busy}, published. Rejected: to stop reading, which makes sensors block and drop on their side, unseen.
 *
 * <p>2026-11-22, the log is written first. A message is applied and answered only once its line is with the operating system, so
 * that what a client was told survives a killed bridge. Lines are not forced to the disk: a power cut may lose the last ones.
 * What is left of a line that could not be written whole is cut off before anything else is written. The file is locked, because
 * two bridges that go on with one log make it the log of neither.
 *
 * <p>2026-11-22, ids. With an id the bridge keeps a hash of what was said: the same id with something else is refused, because two
 * clients that give no source both count from 1, and would be told {@code ok} for what is never applied. {@code t} is not in the
 * hash. Rejected: not to know messages without source again, which would apply a repeated one twice.
 *
 * <p>2026-11-22, sources are who senses: speech, gestures, the scene. A robot or an observer may be silent for as long as they like.
 *
 * <p>2026-11-22, the end. A bridge that is told to stop goes on for at most a second with what waits; how much is left is
 * published, logged and counted as an error {@code busy}.
 *
 * <p>2026-11-22, the mechanism of CURVE is checked by our own few lines of ZAP in the loop, not by JeroMQ's ZAuth, whose thread
 * and certificate store are more than a list of keys needs. Keys are read once, at the start.
 *
 * <p>2026-11-22, the scheduling policy. JeroMQ 0.6.0 counts a signal to another thread ({@code zmq.Signaler.send}) only after it
 * has written the byte that wakes that thread. On Linux the woken I/O thread often takes the processor of the thread that writes,
 * finds the byte but no signal, and polls again and again until the time slice ends: 1 of 100 messages waited 4 to 6 ms (seen in
 * a trace of switches and system calls). {@code scripts/handover} therefore starts a bridge with the batch policy, under which a
 * thread that wakes displaces nobody. Rejected: a patched copy of a class of the library, and a processor for each thread.
 */
package handover.bridge;
