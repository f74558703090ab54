package handover.cli;

import handover.belief.HandoverBelief;
import handover.domain.HandoverDomain;
import handover.io.DomainFiles;
import handover.simulation.Estimate;
import handover.solver.Solver;
import handover.solver.Solvers;
import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.IntFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.hipparchus.stat.regression.SimpleRegression;
import picocli.CommandLine.Option;

/**
 * How the time of a decision grows with the objects N and the observations C, as exponents of a power that is fitted to median times by least
 * squares of their logarithms, and with the acts ahead H, as factors. Times on the processor, so that other programs do not count.
 */
final class BenchGrowth implements BenchPart {
    /** Points of a line: with fewer there is no interval. */
    private static final int FEWEST = 3;

    @Option(names = "--growth-objects", split = ",", paramLabel = "N", defaultValue = "4,6,10,20,50",
            description = "growth: objects (default: ${DEFAULT-VALUE}).")
    private List<Integer> objects;

    @Option(names = "--growth-widths", split = ",", paramLabel = "C", defaultValue = "5,10,20,40",
            description = "growth: observations for each act, with 6 objects and H=2 (default: ${DEFAULT-VALUE}).")
    private List<Integer> widths;

    @Option(names = "--growth-horizons", split = ",", paramLabel = "H", defaultValue = "1,2,3",
            description = "growth: acts ahead, with 4 objects and C=5 (default: ${DEFAULT-VALUE}).")
    private List<Integer> horizons;

    /**
     * One quantity that grows while the others stay.
     *
     * @param what grows
     * @param power whether time is a power of it, else exponential in it
     */
    private record Line(String what, boolean power, List<Integer> values, IntFunction<Solver> solver, IntFunction<Integer> objects) {
        Line {
            values = List.copyOf(values);
        }
    }

    @Override
    public String name() {
        return "growth";
    }

    private List<Line> lines() {
        return List.of(
                new Line("N", true, objects, n -> Solvers.parse("poss:H=1,C=10"), n -> n),
                new Line("N", true, objects, n -> Solvers.parse("poss:H=2,C=5"), n -> n),
                new Line("N", true, objects, n -> Solvers.parse("qmdp"), n -> n),
                new Line("C", true, widths, c -> Solvers.parse("poss:H=2,C=" + c), c -> 6),
                new Line("H", false, horizons, h -> Solvers.parse("poss:C=5,H=" + h), h -> 4));
    }

    @Override
    public void check() {
        for (Map.Entry<String, List<Integer>> e : Map.of("--growth-objects", objects, "--growth-widths", widths, "--growth-horizons",
                horizons).entrySet()) {
            if (e.getValue().stream().distinct().count() < FEWEST) {
                throw new UsageException(e.getKey() + ": expected at least " + FEWEST + " different numbers, got " + e.getValue());
            }
        }
        lines().forEach(l -> l.values.forEach(v -> {
            l.solver.apply(v);
            DomainFiles.read("generated-" + l.objects.apply(v));
        }));
    }

    @Override
    public String run(BenchRun run) throws IOException {
        MarkdownTable table = new MarkdownTable("solver", "grows with", "median CPU ms", "law");
        Progress progress = run.progress("rounds of decisions", lines().size());
        for (Line line : lines()) {
            List<DecisionTimes> points = line.values.stream().map(v -> point(line, v, run)).toList();
            DecisionTimes.measure(points, run.decisions(), run.seconds(), progress::step);
            Map<Integer, Double> medians = new LinkedHashMap<>();
            for (int k = 0; k < points.size(); k++) {
                if (points.get(k).measured()) {
                    medians.put(line.values.get(k), points.get(k).work().median());
                }
            }
            String solver = line.solver.apply(line.values.get(0)).name();
            Map<String, Object> row = new LinkedHashMap<>(Map.of("solver", solver, "grows_with", line.what, "median_cpu_ms", medians));
            String law = "";
            if (medians.size() >= FEWEST && line.power) {
                Estimate e = exponent(medians);
                row.put("exponent", BenchReturn.numbers(e));
                law = BenchReturn.show("%s^%.2f [%.2f, %.2f]", line.what, e.value(), e.low(), e.high());
            } else if (medians.size() >= FEWEST) {
                row.put("factors", factors(medians));
                law = factors(medians).stream().map(f -> BenchReturn.show("x %.0f", f)).collect(Collectors.joining(", "));
            }
            run.report().add(name(), List.of(row));
            table.add(solver, line.what, medians.entrySet().stream().map(e -> e.getKey() + ": " + BenchTime.show(e.getValue()))
                    .collect(Collectors.joining(", ")), law);
        }
        progress.end();
        return "How decision times grow, generated tables of the base variant (the solver as at the first point): exponent with 95% "
                + "interval, or the factor for each further act\n\n" + table.text();
    }

    /** The slope of log y over log x, by least squares. */
    static Estimate exponent(Map<Integer, Double> points) {
        SimpleRegression fit = new SimpleRegression();
        points.forEach((x, y) -> fit.addData(Math.log(x), Math.log(y)));
        double half = fit.getSlopeConfidenceInterval();
        return new Estimate(fit.getSlope(), fit.getSlope() - half, fit.getSlope() + half);
    }

    /** By how much y grows for each 1 that x grows, from each point to the next. */
    static List<Double> factors(Map<Integer, Double> points) {
        List<Integer> xs = List.copyOf(points.keySet());
        return IntStream.range(1, xs.size()).mapToObj(k -> Math.pow(points.get(xs.get(k)) / points.get(xs.get(k - 1)),
                1.0 / (xs.get(k) - xs.get(k - 1)))).toList();
    }

    private static DecisionTimes point(Line line, int value, BenchRun run) {
        HandoverDomain domain = DomainFiles.load("generated-" + line.objects.apply(value));
        List<HandoverBelief> beliefs = BenchBeliefs.of(domain, run.beliefs(), run.seed());
        return new DecisionTimes(new Contender(line.solver.apply(value), 0), domain, beliefs, run.seed(), run.clock());
    }
}
