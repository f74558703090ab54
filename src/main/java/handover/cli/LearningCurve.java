package handover.cli;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.HandoverDomain;
import handover.math.Streams;
import handover.simulation.Episode;
import handover.simulation.EpisodeRunner;
import handover.simulation.Episodes;
import handover.simulation.Estimate;
import handover.simulation.Step;
import handover.simulation.Summary;
import handover.solver.Deadline;
import handover.solver.Decision;
import handover.solver.NearestPolicy;
import handover.solver.Policy;
import handover.solver.PolicyTable;
import handover.solver.Solver;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.LongSupplier;
import java.util.random.RandomGenerator;

/** What the first N beliefs of a table are worth, on the same episodes as the teacher. Used by one thread. */
final class LearningCurve {
    /** Lookups are timed at so many beliefs, after as many that are not counted. */
    private static final int TIMED = 20_000;

    private final HandoverDomain domain;
    private final PolicyTable table;
    private final Solver teacher;
    private final int k;
    private final double radius;
    private final int episodes;
    private final long seed;
    private final LongSupplier nanoClock;
    private final List<Episode> taught;
    private final List<HandoverBelief> beliefs = new ArrayList<>();
    private final List<Act> acts = new ArrayList<>();

    /** A policy that is solved already. */
    private record Solved(String name, Policy policy) implements Solver {
        @Override
        public Policy solve(HandoverDomain domain, RandomGenerator random) {
            return policy;
        }
    }

    /**
     * One point of the curve.
     *
     * @param pure return of the table alone
     * @param pureLoss the teacher's return less that
     * @param agreement share of beliefs at which the table alone does what the teacher did
     * @param backed return with the fallback
     * @param backedLoss the teacher's return less that
     * @param fallback share of beliefs at which the fallback decides
     * @param p50 median time of a lookup, without any fallback, seconds
     * @param p99 the same, 99th percentile
     * @param teacher the teacher's return
     */
    record Point(int beliefs, Estimate pure, Estimate pureLoss, double agreement, Estimate backed, Estimate backedLoss,
            double fallback, double p50, double p99, double teacher) {
        static final String CSV_HEADER = "beliefs,teacher_return,return,return_half,loss,loss_half,agreement,fallback_return,"
                + "fallback_return_half,fallback_loss,fallback_loss_half,fallback_share,lookup_p50_us,lookup_p99_us";

        String csv() {
            return String.format(Locale.ROOT, "%d,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.2f,%.2f", beliefs, teacher,
                    pure.value(), pure.half(), pureLoss.value(), pureLoss.half(), agreement, backed.value(), backed.half(),
                    backedLoss.value(), backedLoss.half(), fallback, 1e6 * p50, 1e6 * p99);
        }

        List<String> cells() {
            return List.of(String.valueOf(beliefs), show(pure), show(pureLoss), percent(pureLoss), format("%.1f", 100 * agreement),
                    show(backed), show(backedLoss), percent(backedLoss), format("%.1f", 100 * fallback), format("%.1f", 1e6 * p50),
                    format("%.1f", 1e6 * p99));
        }

        private String percent(Estimate loss) {
            return format("%.1f", 100 * loss.value() / Math.abs(teacher));
        }
    }

    LearningCurve(HandoverDomain domain, PolicyTable table, Solver teacher, int k, double radius, int episodes, long seed,
            LongSupplier nanoClock) throws InterruptedException {
        this.domain = domain;
        this.table = table;
        this.teacher = teacher;
        this.k = k;
        this.radius = radius;
        this.episodes = episodes;
        this.seed = seed;
        this.nanoClock = nanoClock;
        this.taught = play(teacher);
        for (Episode e : taught) {
            HandoverBelief at = e.start();
            for (Step s : e.steps()) {
                beliefs.add(at);
                acts.add(s.act());
                at = s.belief();
            }
        }
    }

    /** How many beliefs the teacher met. */
    int beliefs() {
        return beliefs.size();
    }

    Estimate teacherReturn() {
        return Summary.of(taught).discountedReturn();
    }

    /** How often the teacher, asked again with other luck, does what it did. */
    double teacherAgreement() {
        Policy policy = teacher.solve(domain, Streams.of(seed, "solve", 0));
        return agreement(policy);
    }

    /** The point of the first so many beliefs. */
    Point at(int size) throws InterruptedException {
        PolicyTable first = size == table.size() ? table : table.first(size);
        Policy otherwise = teacher.solve(domain, Streams.of(seed, "solve", 0));
        Policy pure = new NearestPolicy(first, k, Double.POSITIVE_INFINITY, otherwise, teacher.name());
        Policy backed = new NearestPolicy(first, k, radius, otherwise, teacher.name());
        List<Episode> alone = play(new Solved("nearest", pure));
        List<Episode> helped = play(new Solved("nearest with fallback", backed));
        double[] seconds = lookups(new NearestPolicy(first, k, Double.POSITIVE_INFINITY,
                (belief, deadline, random) -> Decision.of(Act.WAIT), "nothing"));
        return new Point(first.size(), Summary.of(alone).discountedReturn(), Summary.returnDifference(taught, alone), agreement(pure),
                Summary.of(helped).discountedReturn(), Summary.returnDifference(taught, helped), fallbacks(backed),
                rank(seconds, 0.5), rank(seconds, 0.99), teacherReturn().value());
    }

    private List<Episode> play(Solver solver) throws InterruptedException {
        List<Episode> played = new ArrayList<>();
        Episodes.play(new EpisodeRunner(domain, domain, solver, seed, EpisodeRunner.STEP_LIMIT, () -> Deadline.NONE, nanoClock),
                0, episodes, Runtime.getRuntime().availableProcessors(), played::add);
        return played;
    }

    private double agreement(Policy policy) {
        int same = 0;
        for (int i = 0; i < beliefs.size(); i++) {
            same += decide(policy, i).equals(acts.get(i)) ? 1 : 0;
        }
        return (double) same / beliefs.size();
    }

    private Act decide(Policy policy, int i) {
        return policy.decide(beliefs.get(i), Deadline.NONE, Streams.of(seed, "again", i)).act();
    }

    private double fallbacks(Policy policy) {
        long count = 0;
        for (int i = 0; i < beliefs.size(); i++) {
            count += policy.decide(beliefs.get(i), Deadline.NONE, Streams.of(seed, "again", i)).note().isEmpty() ? 0 : 1;
        }
        return (double) count / beliefs.size();
    }

    private double[] lookups(Policy policy) {
        double[] seconds = new double[TIMED];
        for (int i = -TIMED; i < TIMED; i++) {
            HandoverBelief belief = beliefs.get(Math.floorMod(i, beliefs.size()));
            RandomGenerator random = Streams.of(seed, "again", i);
            long before = nanoClock.getAsLong();
            policy.decide(belief, Deadline.NONE, random);
            if (i >= 0) {
                seconds[i] = (nanoClock.getAsLong() - before) / 1e9;
            }
        }
        Arrays.sort(seconds);
        return seconds;
    }

    private static double rank(double[] sorted, double p) {
        return sorted[(int) Math.max(0, Math.ceil(p * sorted.length) - 1)];
    }

    static String show(Estimate e) {
        return format("%.2f+-%.2f", e.value(), e.half());
    }

    private static String format(String format, Object... values) {
        return String.format(Locale.ROOT, format, values);
    }
}
