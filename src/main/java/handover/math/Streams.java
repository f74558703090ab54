package handover.math;

import java.util.SplittableRandom;
import java.util.random.RandomGenerator;

/**
 * Independent random streams named by what they are for, so that the same seed gives the same chance to the same role
 * in the same episode, whatever else draws and on any number of threads.
 */
public final class Streams {
    private Streams() {}

    /** The stream of {@code role} in episode (or other unit of work) {@code index} of the run {@code seed}. */
    public static RandomGenerator of(long seed, String role, long index) {
        return new SplittableRandom(mix(mix(seed, role.hashCode()), index));
    }

    /** A 64-bit hash of two words (the finaliser of MurmurHash3 after a Weyl step). */
    public static long mix(long a, long b) {
        long z = (a + 0x9E3779B97F4A7C15L) ^ Long.rotateLeft(b * 0xD1342543DE82EF95L + 0x632BE59BD9B4E019L, 32);
        z = (z ^ (z >>> 33)) * 0xFF51AFD7ED558CCDL;
        z = (z ^ (z >>> 33)) * 0xC4CEB9FE1A85EC53L;
        return z ^ (z >>> 33);
    }
}
