/**
 * The command line: one class a command, the only place for standard output, exit codes and clocks.
 *
 * <p>2026-11-22, exit codes. 0 fine; 1 a check or replay found a difference, or a run failed; 2 bad input or usage. What goes
 * wrong is one line on standard error that begins with {@code handover:}; the stack trace is for {@code --debug}.
 *
 * <p>2026-11-22, blocks. {@code simulate} plays a block of episodes with every solver before it goes on to the next block, so
 * that the time left can be told from the time taken, and a run that was stopped has compared all solvers on the same
 * episodes. Rejected: one solver after the other, which is simpler, but then the slowest solver makes a fool of the clock.
 *
 * <p>2026-11-22, measuring. {@code bench} measures all contenders at the same beliefs, in turns and in an order that is drawn for each belief, so
 * that a busy machine hits all alike, and reports medians and percentiles, never means. Beside the time by the clock it gives the
 * time on a processor; ratios and laws of growth are of the latter, because on a busy machine a thread waits longer than it works.
 * What Java's own threads do (collecting garbage, compiling) is not in it, which favours planners that allocate. BURLAP's planner
 * knows of no deadline; it is stopped through the chance that it draws. Rejected: one contender after the other, which takes less code, but
 * then one of them may have met the busy minute.
 */
package handover.cli;
