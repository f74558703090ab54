package handover.solver;

import java.util.List;
import java.util.ServiceLoader;
import java.util.function.Function;
import java.util.stream.Stream;

/**
 * The solvers by the names under which people ask for them: {@code NAME}, {@code NAME:key=value,key=value}, or the name of
 * a class. This list is the only place where a new solver is named, but for those that a {@link SolverProvider} makes.
 */
public final class Solvers {
    private static final List<Entry> ALL = List.of(
            new Entry("poss", "looks H=3 acts ahead with C=10 samples; leaf=policy or zero; threads=1",
                    List.of("H", "C", "leaf", "threads"), p -> new Poss(p.count("H", 3, 100), p.count("C", 10, 1_000_000),
                            p.choice("leaf", "policy", "zero").equals("policy"), p.count("threads", 1, 1024))),
            new Entry("anytime", "races the acts: all 2 acts ahead, the best of them H=3 acts ahead with C=128 draws; for deadlines",
                    List.of("H", "C"), p -> new Anytime(p.count("H", 3, 5), p.count("C", 128, 1024))),
            new Entry("threshold", "waits until one object has probability p=0.9, then hands it over",
                    List.of("p"), p -> new Threshold(p.probability("p", 0.9))),
            new Entry("confirm", "asks about the likeliest object until yes, then hands it over",
                    List.of(), p -> new Confirm()),
            new Entry("heuristic", "hands over when sure, points at the likeliest if that is likelier than chance, else waits",
                    List.of(), p -> new Heuristic()),
            new Entry("greedy", "hands over when sure, else makes the person expect what it believes; whatever that costs",
                    List.of(), p -> new Greedy()),
            new Entry("qmdp", "does what would be best if it were told after one step what is wanted",
                    List.of(), p -> new Qmdp()),
            new Entry("burlap", "BURLAP's own BeliefSparseSampling, H=2 acts ahead with C=5 samples: slow; also burlap:bss",
                    List.of("H", "C"), p -> new BurlapSparseSampling(p.count("H", 2, 100), p.count("C", 5, 1_000_000))),
            new Entry("random", "any act, each as likely as the other, but a pick is finished: the floor",
                    List.of(), p -> new RandomActs()),
            new Entry("clairvoyant", "is told what the person wants: the ceiling",
                    List.of(), p -> new Clairvoyant()));

    /** Another name of BURLAP's planner. */
    private static final String BURLAP_BSS = "burlap:bss";

    /** A specification that names no solver, or one with parameters that it cannot have. */
    public static final class BadSolverException extends IllegalArgumentException {
        private static final long serialVersionUID = 1L;

        /** Says what is wrong with a specification. */
        public BadSolverException(String spec, String problem, Throwable cause) {
            super("solver \"" + spec + "\": " + problem, cause);
        }
    }

    private record Entry(String name, String description, List<String> keys, Function<SolverParameters, Solver> make) {}

    private Solvers() {}

    /** The known names, in the order in which help shows them. */
    public static List<String> names() {
        return Stream.concat(ALL.stream().map(Entry::name), providers().map(SolverProvider::name)).toList();
    }

    private static Stream<SolverProvider> providers() {
        return ServiceLoader.load(SolverProvider.class, Solvers.class.getClassLoader()).stream().map(ServiceLoader.Provider::get);
    }

    /** What a known solver does, with its parameters and their defaults, in one line. */
    public static String description(String name) {
        return Stream.concat(ALL.stream().filter(e -> e.name.equals(name)).map(Entry::description),
                providers().filter(p -> p.name().equals(name)).map(SolverProvider::description)).findFirst().orElseThrow();
    }

    /**
     * The solver that a specification asks for.
     *
     * @param spec for instance {@code poss}, {@code poss:H=2,C=10,leaf=zero}, {@code threshold:p=0.95}, or the full name of
     *     a class that implements {@link Solver} and has a public constructor without arguments
     * @throws BadSolverException that says which names or parameters there are
     */
    public static Solver parse(String spec) {
        String name = spec.split(":", 2)[0];
        for (Entry entry : ALL) {
            if (entry.name.equals(name)) {
                return make(s -> entry.make.apply(SolverParameters.of(entry.name, entry.keys, s)), usual(spec));
            }
        }
        SolverProvider provider = providers().filter(p -> p.name().equals(name)).findFirst().orElse(null);
        if (provider != null) {
            return make(provider::make, spec);
        }
        if (name.indexOf('.') > 0) {
            return ofClass(spec);
        }
        throw new BadSolverException(spec, "expected one of " + String.join(", ", names())
                + ", or the full name of a class that implements " + Solver.class.getName(), null);
    }

    private static String usual(String spec) {
        return spec.equals(BURLAP_BSS) ? "burlap" : spec.replaceFirst("^" + BURLAP_BSS + ",", "burlap:");
    }

    private static Solver make(Function<String, Solver> maker, String spec) {
        try {
            return maker.apply(spec);
        } catch (BadSolverException e) {
            throw e;
        } catch (IllegalArgumentException e) {
            throw new BadSolverException(spec, e.getMessage(), e);
        }
    }

    private static Solver ofClass(String name) {
        try {
            ClassLoader loader = Thread.currentThread().getContextClassLoader();
            Class<?> type = Class.forName(name, true, loader == null ? Solvers.class.getClassLoader() : loader);
            return type.asSubclass(Solver.class).getConstructor().newInstance();
        } catch (ClassNotFoundException e) {
            throw new BadSolverException(name, "there is no class of this name on the class path", e);
        } catch (ClassCastException e) {
            throw new BadSolverException(name, "this class does not implement " + Solver.class.getName(), e);
        } catch (ReflectiveOperationException | LinkageError e) {
            throw new BadSolverException(name, "expected a class with a public constructor without arguments: " + e, e);
        }
    }
}
