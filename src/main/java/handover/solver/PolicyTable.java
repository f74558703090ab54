package handover.solver;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;

/** Stored decisions, part by part. Immutable, thread safe. */
public final class PolicyTable {
    private final BeliefMetric metric;
    private final Map<String, PolicyPart> parts = new LinkedHashMap<>();

    /** @param parts no two of the same {@link BeliefPart#depends} */
    public PolicyTable(BeliefMetric metric, Collection<PolicyPart> parts) {
        this.metric = metric;
        for (PolicyPart p : parts) {
            if (this.parts.put(p.part().depends(), p) != null) {
                throw new IllegalArgumentException("expected each part once, got " + p.part() + " twice");
            }
        }
    }

    public BeliefMetric metric() {
        return metric;
    }

    /** In the order in which they were met. */
    public List<PolicyPart> parts() {
        return List.copyOf(parts.values());
    }

    /** The stored beliefs that hold for what a hash says, null if there are none. */
    PolicyPart part(String depends) {
        return parts.get(depends);
    }

    /** How many beliefs are stored. */
    public int size() {
        return parts.values().stream().mapToInt(PolicyPart::size).sum();
    }

    /** The table of the first so many beliefs that were met. */
    public PolicyTable first(int beliefs) {
        List<PolicyPart> all = new ArrayList<>();
        for (PolicyPart p : parts.values()) {
            int[] rows = IntStream.range(0, p.size()).filter(r -> p.ordinals()[r] < beliefs).toArray();
            if (rows.length > 0) {
                all.add(PolicyRows.of(p, rows));
            }
        }
        return new PolicyTable(metric, all);
    }

    /** Collects parts from beliefs in the order in which they are met. Used by one thread. */
    public static final class Builder {
        private final BeliefMetric metric;
        private final Map<String, PolicyRows> rows = new LinkedHashMap<>();
        private final Map<PolicyRows.Key, Integer> known = new HashMap<>();
        private final int most;
        private int size;

        /** @param most distinct beliefs; others are then not added any more */
        public Builder(BeliefMetric metric, int most) {
            this.metric = metric;
            this.most = most;
        }

        /** Distinct beliefs so far. */
        public int size() {
            return size;
        }

        /**
         * Adds a belief. One that was met before is not stored again: its values become the mean of all its decisions, so
         * that the beliefs met most often, for instance that at the start, are known best.
         *
         * @return whether it was new and is stored
         */
        public boolean add(StoredBelief belief) {
            PolicyRows.Key key = new PolicyRows.Key(belief);
            Integer row = known.get(key);
            if (row != null) {
                rows.get(belief.part().depends()).merge(row, belief);
                return false;
            } else if (size == most) {
                return false;
            }
            PolicyRows part = rows.computeIfAbsent(belief.part().depends(),
                    d -> new PolicyRows(belief.part(), belief.values().length));
            known.put(key, part.size());
            part.add(belief, size++);
            return true;
        }

        /** The table of all that was added. */
        public PolicyTable build() {
            return new PolicyTable(metric, rows.values().stream().map(PolicyRows::build).toList());
        }
    }
}
