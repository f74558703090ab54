package handover.simulation;

import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/** Plays many episodes on several threads and hands them on in order, each as soon as all before it are there. */
public final class Episodes {
    private Episodes() {}

    /**
     * Plays episodes {@code from} to {@code to - 1}.
     *
     * @param finished is called with one episode after the other, by one thread at a time
     * @throws InterruptedException if interrupted; what was handed on by then stands
     */
    public static void play(EpisodeRunner runner, int from, int to, int threads, Consumer<Episode> finished)
            throws InterruptedException {
        AtomicInteger next = new AtomicInteger(from);
        InOrder inOrder = new InOrder(from, finished);
        ExecutorService pool = Executors.newFixedThreadPool(threads);
        try {
            List<Future<?>> workers = new ArrayList<>();
            for (int t = 0; t < threads; t++) {
                workers.add(pool.submit(() -> {
                    for (int k = next.getAndIncrement(); k < to && !Thread.interrupted(); k = next.getAndIncrement()) {
                        inOrder.add(runner.play(k));
                    }
                }));
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

    /** Holds back episodes that finished before their predecessors. */
    private static final class InOrder {
        private final Map<Integer, Episode> waiting = new TreeMap<>();
        private final Consumer<Episode> sink;
        private int next;

        InOrder(int first, Consumer<Episode> sink) {
            this.next = first;
            this.sink = sink;
        }

        synchronized void add(Episode episode) {
            waiting.put(episode.index(), episode);
            while (waiting.containsKey(next)) {
                sink.accept(waiting.remove(next++));
            }
        }
    }
}
