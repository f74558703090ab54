/**
 * The command line: one class a command, the only place for standard output, exit codes and clocks.
 *
 * <p>2026-11-22, exit codes. 0 fine; 1 a check or replay found a difference, or a run failed; 2 bad input or usage. What goes
 * wrong is one line on standard error that begins with {@code handover:}; the stack trace is for {@code --debug}.
 *
 * <p>2026-11-22, blocks. {@code simulate} plays a block of episodes with every solver before it goes on to the next block, so
 * that the time left can be told from the time taken, and a run that was stopped has compared all solvers on the same
 * episodes. Rejected: one solver after the other, which is simpler, but then the slowest solver makes a fool of the clock.
 */
package handover.cli;
