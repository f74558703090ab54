package handover.cli;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;

/** What the calling thread has used so far, as this Java counts it. */
final class ThreadMeter {
    private static final java.lang.management.ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();
    private static final ThreadMXBean ALLOCATION = THREADS instanceof ThreadMXBean more && more.isThreadAllocatedMemorySupported()
            ? more : null;

    private ThreadMeter() {}

    /** Bytes allocated since the thread began; -1 if this Java does not count them. */
    static long bytes() {
        return ALLOCATION == null ? -1 : ALLOCATION.getThreadAllocatedBytes(Thread.currentThread().getId());
    }

    /** Nanoseconds that the thread was on a processor; {@code otherwise} if this Java does not count them. */
    static long nanos(long otherwise) {
        return THREADS.isCurrentThreadCpuTimeSupported() ? THREADS.getCurrentThreadCpuTime() : otherwise;
    }
}
