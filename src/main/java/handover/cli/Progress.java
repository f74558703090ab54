package handover.cli;

import java.util.Locale;

/** How far a long run is, on standard error: a line that is written over on a terminal, else a line now and then. */
final class Progress {
    private static final double LIVE_SECONDS = 0.2;
    private static final double FIRST_LINE_SECONDS = 1;
    private static final double LINE_SECONDS = 4;
    private static final double PATIENT_SECONDS = 90;
    private static final int BAR = 20;

    private final Console console;
    private final String what;
    private final long total;
    private final long before;
    private final long start;
    private double shown;
    private long done;
    private int width;

    /**
     * @param what is done, in the plural
     * @param done how much was done before the start
     * @param total how much there is to do
     */
    Progress(Console console, String what, long done, long total) {
        this.console = console;
        this.what = what;
        this.before = done;
        this.done = done;
        this.total = total;
        this.start = console.nanoClock().getAsLong();
    }

    /** One more is done. */
    void step() {
        at(done + 1);
    }

    /** What is done before the next step, which may take long; shown on a terminal only. */
    void note(String text) {
        if (console.live()) {
            show(text);
        }
    }

    /** So many are done now. */
    void at(long now) {
        done = now;
        double seconds = (console.nanoClock().getAsLong() - start) / 1e9;
        double pause = console.live() ? LIVE_SECONDS : shown == 0 ? FIRST_LINE_SECONDS : LINE_SECONDS;
        if (seconds - shown >= pause) {
            shown = seconds;
            show(line(what, done, total, (done - before) / seconds));
        }
    }

    /** Clears the live line. */
    void end() {
        if (width > 0) {
            console.err().print("\r" + " ".repeat(width) + "\r");
            console.err().flush();
            width = 0;
        }
    }

    static String line(String what, long done, long total, double perSecond) {
        int full = (int) (BAR * done / total);
        double left = (total - done) / perSecond;
        String time = !(left < Integer.MAX_VALUE) ? "unknown time" : left < PATIENT_SECONDS ? Math.round(left) + " s"
                : Math.round(left / 60) + " min";
        return String.format(Locale.ROOT, "[%s%s] %d of %d %s, %.0f a second, about %s left", "#".repeat(full),
                ".".repeat(BAR - full), done, total, what, perSecond, time);
    }

    private void show(String line) {
        if (console.live()) {
            console.err().print("\r" + line + " ".repeat(Math.max(0, width - line.length())));
            console.err().flush();
            width = line.length();
        } else {
            console.err().println(line);
        }
    }
}
