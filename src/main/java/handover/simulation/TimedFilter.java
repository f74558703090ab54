package handover.simulation;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.PickSignal;
import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;

/**
 * The robot's belief, moved by what it does and by what arrives. Evidence is weighed against the act that was under way when it
 * was said or shown, also if it arrives after the next act started: then what followed is filtered again. Each change
 * makes a new version. Used by one thread.
 */
final class TimedFilter {
    private final List<Stage> stages = new ArrayList<>();
    private long version;

    /** A belief before any act. */
    TimedFilter(HandoverBelief belief) {
        stages.add(new Stage(Double.NEGATIVE_INFINITY, null, belief));
    }

    private record Evidence(double at, UnaryOperator<HandoverBelief> correct) {}

    /** An act and what was sensed while it was the last one. */
    private static final class Stage {
        private final double start;
        private final Act act;
        private final List<Evidence> evidence = new ArrayList<>();
        private HandoverBelief predicted;
        private boolean stalled;
        private HandoverBelief now;

        Stage(double start, Act act, HandoverBelief predicted) {
            this.start = start;
            this.act = act;
            this.predicted = predicted;
            this.now = predicted;
        }

        /** In the order in which it happened; of two things at once, the one that was reported first. */
        void add(Evidence more) {
            int k = evidence.size();
            while (k > 0 && evidence.get(k - 1).at > more.at) {
                k--;
            }
            evidence.add(k, more);
        }

        void filter() {
            now = stalled ? predicted.stalled() : predicted;
            evidence.forEach(e -> now = e.correct.apply(now));
        }
    }

    /** How often the belief changed. */
    long version() {
        return version;
    }

    /** The belief; the step under way is open. */
    HandoverBelief now() {
        return last().now;
    }

    /** What is believed if nothing more comes before the next act: the step under way is closed, unless there was no act yet. */
    HandoverBelief settled() {
        return last().act == null ? last().now : last().now.closed();
    }

    private Stage last() {
        return stages.get(stages.size() - 1);
    }

    /** An act starts. Throws {@link IllegalArgumentException} if it is not legal. */
    void started(double time, Act act) {
        stages.add(new Stage(time, act, now().after(act)));
        version++;
    }

    /** Something is reported. */
    void sensed(Arrival arrival) {
        add(new Evidence(arrival.at(), arrival::correct));
    }

    /** The last act that started is over, with what became of it if it is a pick. */
    void ended(double time, PickSignal signal) {
        if (signal == PickSignal.ACCEPTED || signal == PickSignal.REJECTED) {
            add(new Evidence(time, b -> b.picked(signal == PickSignal.ACCEPTED)));
        } else if (signal == PickSignal.NONE && last().predicted.stalled() != last().predicted) {
            last().stalled = true;
            last().filter();
            version++;
        }
    }

    private void add(Evidence evidence) {
        int k = stages.size() - 1;
        while (stages.get(k).start > evidence.at) {
            k--;
        }
        stages.get(k).add(evidence);
        stages.get(k).filter();
        for (int next = k + 1; next < stages.size(); next++) {
            stages.get(next).predicted = stages.get(next - 1).now.after(stages.get(next).act);
            stages.get(next).filter();
        }
        version++;
    }
}
