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
 * all of its time would never be asked again; but only if at least as much time is left as was spent, so that a belief that
 * never rests still gets a plan.
 *
 * <p>2026-11-22, late observations. What was sensed before the last act is weighed by computing the belief again from the act
 * before which it belongs ({@link handover.belief.Timeline}); this equals what would be believed had it come in time. A {@code t}
 * in the future counts as now, and when the clock is set back the times of earlier acts are forgotten: a clock that is wrong
 * must not make everything stale.
 *
 * <p>2026-11-22, the table. An object that was added gets 1/N of b and h, the others share the rest as before: nothing was sensed
 * yet that speaks for or against it. What was reported by {@code scene} also holds for the next episode, and what was handed over
 * is then back. V stays that of the domain file (MODEL 4.1), so words that only an added object has are unknown.
 *
 * <p>2026-11-22, the stream. Messages are decoded when they are read, so that gestures and unfinal speech can give way, the
 * oldest first, when too many wait. What must not be lost is never dropped; if nothing else is left to drop it is refused with
 * {@code busy}, published. Rejected: to stop reading, which makes sensors block and drop on their side, unseen.
 *
 * <p>2026-11-22, the log is written first. A message is applied and answered only once its line is with the operating system, so
 * that what a client was told survives a killed bridge. Lines are not forced to the disk: a power cut may lose the last ones.
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
