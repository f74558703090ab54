package handover.solver;

import handover.domain.ActModel;
import handover.domain.HandoverDomain;

/** h' after each act for one h, filled on demand. Used by one thread at a time. */
final class Expectations {
    private final HandoverDomain domain;
    private final int capacity;
    private final double[][] after;
    private final int[] filled;
    private int current;

    /** For scenes of at most so many objects and acts. */
    Expectations(HandoverDomain domain, int objects, int acts) {
        this.domain = domain;
        this.capacity = objects;
        this.after = new double[acts][];
        this.filled = new int[acts];
    }

    void reset() {
        current++;
    }

    double[] after(ActModel act, double[] h) {
        int a = act.index();
        if (filled[a] != current || after[a] == null) {
            if (after[a] == null) {
                after[a] = new double[capacity];
            }
            domain.understand(act, h, after[a], act.lambda().length);
            filled[a] = current;
        }
        return after[a];
    }
}
