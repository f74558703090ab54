package handover.simulation;

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
        OrderedUnits.until(from, to, threads, runner::play, episode -> {
            finished.accept(episode);
            return false;
        });
    }
}
