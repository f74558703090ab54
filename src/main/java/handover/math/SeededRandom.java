package handover.math;

import java.util.random.RandomGenerator;

/**
 * A generator that can be set to any seed without allocation, for searches that draw the same numbers again for every act
 * they compare (common random numbers). Used by one thread at a time.
 *
 * <p>Source: SplitMix64 (Steele, Lea and Flood, "Fast splittable pseudorandom number generators", 2014).
 */
public final class SeededRandom implements RandomGenerator {
    private static final long GOLDEN = 0x9E3779B97F4A7C15L;

    private long state;

    /** Starts the sequence of {@code seed}. */
    public void seed(long seed) {
        state = seed;
    }

    @Override
    public long nextLong() {
        state += GOLDEN;
        long z = (state ^ (state >>> 30)) * 0xBF58476D1CE4E5B9L;
        z = (z ^ (z >>> 27)) * 0x94D049BB133111EBL;
        return z ^ (z >>> 31);
    }

    @Override
    public double nextDouble() {
        return (nextLong() >>> 11) * 0x1.0p-53;
    }
}
