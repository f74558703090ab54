package handover.solver;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** The beliefs of one part while they are collected. Used by one thread. */
final class PolicyRows {
    private final BeliefPart part;
    private final int acts;
    private final List<Row> rows = new ArrayList<>();

    /** A belief with the sums of what was decided there. */
    private static final class Row {
        private final float[] coordinates;
        private final int ordinal;
        private final double[] sums;
        private final int[] chosen;
        private int times;

        Row(StoredBelief first, int ordinal) {
            coordinates = first.coordinates();
            sums = new double[first.values().length];
            chosen = new int[first.values().length];
            this.ordinal = ordinal;
            add(first);
        }

        void add(StoredBelief again) {
            for (int a = 0; a < sums.length; a++) {
                sums[a] += again.values()[a];
            }
            chosen[again.act()]++;
            times++;
        }

        float value(int act) {
            return (float) (sums[act] / times);
        }

        /** The act with the best mean, or where there are no values the one chosen most often; ties: the first. */
        int choice() {
            if (times == 1) {
                return only();
            }
            int best = -1;
            for (int a = 0; a < sums.length; a++) {
                if (!Double.isNaN(sums[a]) && (best < 0 || sums[a] > sums[best])) {
                    best = a;
                }
            }
            return best >= 0 ? best : most();
        }

        private int only() {
            int a = 0;
            while (chosen[a] == 0) {
                a++;
            }
            return a;
        }

        private int most() {
            int best = 0;
            for (int a = 1; a < chosen.length; a++) {
                best = chosen[a] > chosen[best] ? a : best;
            }
            return best;
        }
    }

    /** What makes two stored beliefs the same. */
    record Key(String depends, float[] coordinates) {
        Key(StoredBelief belief) {
            this(belief.part().depends(), belief.coordinates());
        }

        @Override
        public boolean equals(Object o) {
            return o instanceof Key k && depends.equals(k.depends) && Arrays.equals(coordinates, k.coordinates);
        }

        @Override
        public int hashCode() {
            return 31 * depends.hashCode() + Arrays.hashCode(coordinates);
        }
    }

    PolicyRows(BeliefPart part, int acts) {
        this.part = part;
        this.acts = acts;
    }

    int size() {
        return rows.size();
    }

    void add(StoredBelief belief, int ordinal) {
        rows.add(new Row(belief, ordinal));
    }

    void merge(int row, StoredBelief again) {
        rows.get(row).add(again);
    }

    PolicyPart build() {
        int n = rows.size();
        float[] points = new float[n * part.dimensions()];
        float[] values = new float[n * acts];
        int[] choices = new int[n];
        int[] ordinals = new int[n];
        for (int r = 0; r < n; r++) {
            Row row = rows.get(r);
            System.arraycopy(row.coordinates, 0, points, r * part.dimensions(), part.dimensions());
            for (int a = 0; a < acts; a++) {
                values[r * acts + a] = row.value(a);
            }
            choices[r] = row.choice();
            ordinals[r] = row.ordinal;
        }
        return ordered(part, acts, points, values, choices, ordinals);
    }

    /** Some rows of a part, as a part. */
    static PolicyPart of(PolicyPart p, int[] rows) {
        int d = p.part().dimensions();
        return ordered(p.part(), p.acts(), gather(p.coordinates(), d, rows), gather(p.values(), p.acts(), rows),
                gather(p.choices(), rows), gather(p.ordinals(), rows));
    }

    private static PolicyPart ordered(BeliefPart part, int acts, float[] points, float[] values, int[] choices, int[] ordinals) {
        int[] order = PointTree.order(points, part.dimensions());
        return new PolicyPart(part, acts, gather(points, part.dimensions(), order), gather(values, acts, order),
                gather(choices, order), gather(ordinals, order));
    }

    private static float[] gather(float[] from, int width, int[] rows) {
        float[] to = new float[rows.length * width];
        for (int r = 0; r < rows.length; r++) {
            System.arraycopy(from, rows[r] * width, to, r * width, width);
        }
        return to;
    }

    private static int[] gather(int[] from, int[] rows) {
        return Arrays.stream(rows).map(r -> from[r]).toArray();
    }
}
