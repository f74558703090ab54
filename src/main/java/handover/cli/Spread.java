package handover.cli;

import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Numbers in order, for nearest-rank percentiles. Immutable. */
final class Spread {
    private final double[] sorted;

    /** At least one number. */
    Spread(Collection<? extends Number> numbers) {
        if (numbers.isEmpty()) {
            throw new IllegalArgumentException("expected at least one number");
        }
        sorted = numbers.stream().mapToDouble(Number::doubleValue).sorted().toArray();
    }

    int count() {
        return sorted.length;
    }

    /** The smallest number that is at least as large as this share of them, in [0, 1]. */
    double at(double share) {
        return sorted[(int) Math.max(0, Math.ceil(share * sorted.length) - 1)];
    }

    double median() {
        return at(0.5);
    }

    double p90() {
        return at(0.9);
    }

    double p99() {
        return at(0.99);
    }

    double max() {
        return at(1);
    }

    /** Median, p90, p99 and largest, each named after {@code what}. */
    Map<String, Object> row(String what) {
        Map<String, Object> row = new LinkedHashMap<>();
        List.of("median", "p90", "p99", "max").forEach(name -> row.put(name + "_" + what, switch (name) {
            case "median" -> median();
            case "p90" -> p90();
            case "p99" -> p99();
            default -> max();
        }));
        return row;
    }
}
