/**
 * What the toolkit reads and writes: domain files and human files here are a {@link handover.domain.DomainSpec} as JSON,
 * checked so strictly that a typing error is a message with file, path, value and expectation, never a default.
 *
 * <p>2026-11-22, shape before binding. A file is laid over the defaults ({@code DomainSpec.of}, their only place), then
 * its shape is checked against the records by reflection, and only then does Jackson make the records, whose own range
 * checks come last. Rejected: Jackson alone, which coerces, names Java classes in its messages and reports what is missing
 * before the misspelled key that explains it; and validation against the JSON Schema, which is for editors: its messages
 * speak of the schema, and a second description of the format would decide what is valid. Tests hold schema and reader
 * together.
 *
 * <p>2026-11-22, numbers. Read as doubles, not as decimals, so that -0.0 survives a round trip. NaN, Infinity and 1e999
 * are stopped in the parser, where their spelling is still known.
 *
 * <p>2026-11-22, new acts. A variant may add acts, so an unknown verb is no error; but it must give all of its fields,
 * because a new act has no defaults and because a mistyped verb then does not pass for one.
 *
 * <p>2026-11-22, timed episodes are in the log of episodes: {@code timed} in the first line, the agent, and {@code time} in each step, with
 * when what the human said and showed was said and arrived. What it was is where it is in other logs, in the step that it reacts to. So
 * whoever reads acts, beliefs and measures need not know of time; only {@code replay} must, because the belief after a step is that of the
 * moment at which the next act started. Rejected: a second format, or a list of events, from which every reader would have to find the
 * steps again.
 *
 * <p>2026-11-22, .POMDP files whose {@code start} comes late. A row that is {@code reset} is filled when the file ends, in the next states that
 * were not set since, so that the place of {@code start} does not matter. Rejected: to refuse a {@code start} after T, O and R, because such
 * files were read so far; and to take the start as it is known at the row, which made a late one silently uniform.
 */
package handover.io;
