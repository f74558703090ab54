/** Micro-benchmarks, run by {@code scripts/jmh} and never by the tests. */
package handover.benchmark;
