package handover.simulation;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.IntFunction;
import java.util.function.Predicate;

/**
 * Does numbered units of work on several threads and hands their results on in order, until there is enough. What follows does
 * not depend on the number of threads.
 *
 * @param <T> a result
 */
public final class OrderedUnits<T> {
    private final IntFunction<T> work;
    private final Predicate<T> sink;
    private final Map<Integer, T> waiting = new TreeMap<>();
    private final int end;
    private final AtomicInteger taken;
    private final AtomicBoolean enough = new AtomicBoolean();
    private int next;

    private OrderedUnits(int first, int end, IntFunction<T> work, Predicate<T> sink) {
        this.work = work;
        this.sink = sink;
        this.end = end;
        this.taken = new AtomicInteger(first);
        this.next = first;
    }

    /**
     * Does the units from {@code first} to {@code end - 1}.
     *
     * @param sink is called with one result after the other, by one thread at a time, until it says that this is enough
     * @throws InterruptedException if interrupted; what was handed on by then stands
     */
    public static <T> void until(int first, int end, int threads, IntFunction<T> work, Predicate<T> sink)
            throws InterruptedException {
        OrderedUnits<T> units = new OrderedUnits<>(first, end, work, sink);
        ExecutorService pool = Executors.newFixedThreadPool(threads);
        try {
            List<Future<?>> workers = new ArrayList<>();
            for (int t = 0; t < threads; t++) {
                workers.add(pool.submit(units::run));
            }
            for (Future<?> worker : workers) {
                worker.get();
            }
        } catch (ExecutionException e) {
            if (e.getCause() instanceof RuntimeException cause) {
                throw cause;
            }
            throw new IllegalStateException(e.getCause());
        } finally {
            pool.shutdownNow();
            pool.awaitTermination(1, TimeUnit.MINUTES);
        }
    }

    private void run() {
        try {
            for (int k = taken.getAndIncrement(); k < end && !stopped(); k = taken.getAndIncrement()) {
                add(k, work.apply(k));
            }
        } catch (RuntimeException | Error e) {
            enough.set(true);
            throw e;
        }
    }

    private boolean stopped() {
        return enough.get() || Thread.currentThread().isInterrupted();
    }

    private synchronized void add(int k, T result) {
        waiting.put(k, result);
        while (!enough.get() && waiting.containsKey(next)) {
            if (sink.test(waiting.remove(next++))) {
                enough.set(true);
            }
        }
    }
}
