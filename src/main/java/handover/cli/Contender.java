package handover.cli;

import handover.solver.Solver;
import handover.solver.Solvers;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * A solver with a time limit for each decision, written {@code SPEC@MS}.
 *
 * @param ms milliseconds, 0 for none
 */
record Contender(Solver solver, int ms) {
    private static final int LONGEST = 3_600_000;

    /** {@code SPEC}, {@code SPEC@MS}, or {@code SPEC@MS/MS/...} for several. Throws for what is none. */
    static List<Contender> parse(String text) {
        int at = text.lastIndexOf('@');
        if (at < 0) {
            return List.of(new Contender(Solvers.parse(text), 0));
        }
        Solver solver = Solvers.parse(text.substring(0, at));
        List<Contender> all = new ArrayList<>();
        for (String ms : text.substring(at + 1).split("/", -1)) {
            int value = ms.matches("[0-9]{1,7}") ? Integer.parseInt(ms) : 0;
            if (value < 1 || value > LONGEST) {
                throw new UsageException("\"" + text + "\": expected milliseconds from 1 to " + LONGEST + " after @, several as 5/20/50");
            }
            all.add(new Contender(solver, value));
        }
        return all;
    }

    /**
     * Those of several texts, in order.
     *
     * @param option what messages call it
     */
    static List<Contender> parse(String option, List<String> texts) {
        List<Contender> all = texts.stream().flatMap(t -> parse(t).stream()).toList();
        Set<String> names = new HashSet<>();
        for (Contender c : all) {
            if (!names.add(c.name())) {
                throw new UsageException(option + ": expected each solver once, got " + c.name() + " twice");
            }
        }
        return all;
    }

    /** As it is written. */
    String name() {
        return solver.name() + (ms == 0 ? "" : "@" + ms);
    }
}
