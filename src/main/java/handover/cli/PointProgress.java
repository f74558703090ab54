package handover.cli;

import java.util.Locale;

/** How far a precompute is, on standard error: a line that is written over on a terminal, else a line now and then. */
final class PointProgress {
    private static final double LIVE_SECONDS = 0.2;
    private static final double LINE_SECONDS = 10;
    private static final double PATIENT_SECONDS = 90;
    private static final int BAR = 20;

    private final Console console;
    private final int before;
    private final int total;
    private final long start;
    private double shown;
    private int width;

    /**
     * @param before beliefs that were solved before the start
     * @param total beliefs to solve
     */
    PointProgress(Console console, int before, int total) {
        this.console = console;
        this.before = before;
        this.total = total;
        this.start = console.nanoClock().getAsLong();
    }

    /** So many are solved now. */
    void at(int done) {
        double now = (console.nanoClock().getAsLong() - start) / 1e9;
        if (now - shown >= (console.live() ? LIVE_SECONDS : LINE_SECONDS)) {
            shown = now;
            show(line(done, total, (done - before) / now));
        }
    }

    static String line(int done, int total, double perSecond) {
        int full = (int) ((long) BAR * done / total);
        double left = (total - done) / perSecond;
        String time = !(left < Integer.MAX_VALUE) ? "unknown time" : left < PATIENT_SECONDS ? Math.round(left) + " s"
                : Math.round(left / 60) + " min";
        return String.format(Locale.ROOT, "[%s%s] %d of %d beliefs, %.0f a second, about %s left", "#".repeat(full),
                ".".repeat(BAR - full), done, total, perSecond, time);
    }

    /** Clears the live line. */
    void end() {
        if (width > 0) {
            console.err().print("\r" + " ".repeat(width) + "\r");
            console.err().flush();
            width = 0;
        }
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
