package handover.bridge;

import java.util.Arrays;

/** The newest {@value #KEPT} of many durations. Used by one thread. */
final class Latencies {
    private static final int KEPT = 8192;

    private final long[] nanos = new long[KEPT];
    private long count;

    void add(long duration) {
        nanos[(int) (count++ % KEPT)] = duration;
    }

    /** Milliseconds that the given parts of the durations do not exceed, in [0, 1]; empty if there are none. */
    double[] quantiles(double... parts) {
        int n = (int) Math.min(count, KEPT);
        long[] sorted = Arrays.copyOf(nanos, n);
        Arrays.sort(sorted);
        return n == 0 ? new double[0]
                : Arrays.stream(parts).map(p -> sorted[Math.max(0, (int) Math.ceil(p * n) - 1)] / 1e6).toArray();
    }
}
