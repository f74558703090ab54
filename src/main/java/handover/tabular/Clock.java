package handover.tabular;

import handover.solver.Deadline;

/** Asks a deadline often enough, but not all the time. Used by one thread. */
final class Clock {
    /** Elementary steps, of about a nanosecond each. */
    private static final int STEPS_BETWEEN_CHECKS = 20_000;

    private Deadline deadline = Deadline.NONE;
    private int steps;
    private boolean late;

    void start(Deadline until) {
        deadline = until;
        steps = 0;
        late = until.passed();
    }

    void spend(int more) {
        steps += more;
        if (steps > STEPS_BETWEEN_CHECKS) {
            steps = 0;
            late |= deadline.passed();
        }
    }

    boolean late() {
        return late;
    }
}
