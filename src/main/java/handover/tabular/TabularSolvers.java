package handover.tabular;

import handover.solver.SolverParameters;
import handover.solver.Solvers;
import java.util.List;
import java.util.function.Function;

/**
 * The solvers of tabular problems by the names under which people ask for them, as {@link Solvers} has those of handover domains; the
 * same name means the same idea. This list is the only place where a new one is named.
 */
public final class TabularSolvers {
    private static final int MOST = 100_000_000;

    private static final List<Entry> ALL = List.of(
            new Entry("anytime", "bounded search at each decision, after warm=100000 beliefs offline (none: 0); stops at a relative"
                    + " gap=0.001 or at most=200000 beliefs", List.of("gap", "warm", "most"),
                    p -> new AnytimeTabular(gap(p, 1e-3), p.values().getOrDefault("warm", "").equals("0") ? 0
                            : p.count("warm", 100_000, MOST), p.count("most", 200_000, MOST))),
            new Entry("point-based", "the same search offline only, from the start, until a relative gap=0.01 or most=5000000 beliefs",
                    List.of("gap", "most"), p -> new PointBased(gap(p, 1e-2), p.count("most", 5_000_000, MOST))),
            new Entry("exact", "looks H=2 acts ahead, weighing all observations", List.of("H"),
                    p -> new ExactTabular(p.count("H", 2, 100))),
            new Entry("poss", "looks H=3 acts ahead with C=10 samples", List.of("H", "C"),
                    p -> new TabularPoss(p.count("H", 3, 100), p.count("C", 10, 1_000_000))),
            new Entry("qmdp", "does what would be best if the state were told after one step", List.of(), p -> new Informed(false)),
            new Entry("fib", "the same by the fast informed bound", List.of(), p -> new Informed(true)),
            new Entry("random", "any act: the floor", List.of(), p -> new RandomTabular()));

    private record Entry(String name, String description, List<String> keys, Function<SolverParameters, TabularSolver> make) {}

    private TabularSolvers() {}

    private static double gap(SolverParameters p, double otherwise) {
        return p.amount("gap", otherwise, "the gap between the bounds at which to stop, as a share of the value");
    }

    /** The known names, in the order in which help shows them. */
    public static List<String> names() {
        return ALL.stream().map(Entry::name).toList();
    }

    /** What a known solver does, with its parameters and their defaults, in one line. */
    public static String description(String name) {
        return ALL.stream().filter(e -> e.name.equals(name)).findFirst().orElseThrow().description;
    }

    /**
     * The solver that a specification asks for.
     *
     * @param spec for instance {@code anytime} or {@code poss:H=2,C=10}
     * @throws Solvers.BadSolverException that says which names or parameters there are
     */
    public static TabularSolver parse(String spec) {
        String name = spec.split(":", 2)[0];
        Entry entry = ALL.stream().filter(e -> e.name.equals(name)).findFirst().orElseThrow(() ->
                new Solvers.BadSolverException(spec, "expected one of " + String.join(", ", names()), null));
        return entry.make.apply(SolverParameters.of(entry.name, entry.keys, spec));
    }
}
