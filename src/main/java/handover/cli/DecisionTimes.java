package handover.cli;

import handover.belief.HandoverBelief;
import handover.domain.HandoverDomain;
import handover.math.Streams;
import handover.solver.Deadline;
import handover.solver.Decision;
import handover.solver.Policy;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.function.LongSupplier;
import java.util.random.RandomGenerator;
import java.util.stream.Collectors;

/**
 * Decisions of one contender on one domain, measured on the calling thread. Several are measured in turns, belief by belief in
 * an order that is drawn each time, so that whatever else the machine does hits all alike ({@link #measure}). Used by one thread.
 */
final class DecisionTimes {
    /** A contender that does not finish in this time is not measured without a limit. */
    static final int PATIENCE_MS = 10_000;
    private static final int FEWEST = 3;
    private static final double WARM_UP = 0.5;
    private static final int WARM_UP_DECISIONS = 500;
    private static final double NANOS = 1e9;
    private static final double MS = 1e6;

    private final Contender contender;
    private final List<HandoverBelief> beliefs;
    private final Policy policy;
    private final long seed;
    private final LongSupplier nanoClock;
    private final List<Double> ms = new ArrayList<>();
    private final List<Double> work = new ArrayList<>();
    private final List<Double> late = new ArrayList<>();
    private final List<Double> lateAtWork = new ArrayList<>();
    private final List<Long> nodes = new ArrayList<>();
    private final List<Integer> depth = new ArrayList<>();
    private final List<Long> bytes = new ArrayList<>();
    private int finished;
    private double spent;
    private boolean hopeless;

    DecisionTimes(Contender contender, HandoverDomain domain, List<HandoverBelief> beliefs, long seed, LongSupplier nanoClock) {
        this.contender = contender;
        this.beliefs = beliefs;
        this.seed = seed;
        this.nanoClock = nanoClock;
        this.policy = contender.solver().solve(domain, Streams.of(seed, "solve", 0));
    }

    /**
     * Measures contenders in turns.
     *
     * @param decisions at most, of each
     * @param seconds at which a contender that has decided a few times is out
     * @param round is called after each round
     */
    static void measure(List<DecisionTimes> all, int decisions, double seconds, Runnable round) {
        all.forEach(t -> t.warmUp(seconds * WARM_UP));
        Random order = new Random(1);
        List<DecisionTimes> left = new ArrayList<>(all);
        for (int k = 0; k < decisions; k++) {
            left = left.stream().filter(t -> t.goesOn(seconds)).collect(Collectors.toCollection(ArrayList::new));
            Collections.shuffle(left, order);
            for (DecisionTimes t : left) {
                t.decide(k);
            }
            round.run();
        }
    }

    private boolean goesOn(double seconds) {
        return !hopeless && (spent < seconds || ms.size() < FEWEST);
    }

    private void warmUp(double seconds) {
        hopeless = contender.ms() == 0
                && !policy.decide(beliefs.get(0), Deadlines.after(PATIENCE_MS, nanoClock).get(), chance(0)).finished();
        double start = nanoClock.getAsLong();
        for (int k = 0; k < WARM_UP_DECISIONS && !hopeless && nanoClock.getAsLong() - start < seconds * NANOS; k++) {
            policy.decide(beliefs.get(k % beliefs.size()), Deadlines.after(contender.ms(), nanoClock).get(), chance(k));
        }
    }

    private RandomGenerator chance(int k) {
        return Streams.of(seed, "planner", k);
    }

    private void decide(int k) {
        HandoverBelief belief = beliefs.get(k % beliefs.size());
        RandomGenerator chance = chance(k);
        long allocated = ThreadMeter.bytes();
        long working = ThreadMeter.nanos(0);
        long start = nanoClock.getAsLong();
        Deadline deadline = Deadlines.after(contender.ms(), nanoClock).get();
        Decision decision = policy.decide(belief, deadline, chance);
        long nanos = nanoClock.getAsLong() - start;
        long worked = Math.min(nanos, ThreadMeter.nanos(nanos) - working);
        bytes.add(ThreadMeter.bytes() - allocated);
        ms.add(nanos / MS);
        work.add(worked / MS);
        late.add(Math.max(0, nanos / MS - contender.ms()));
        lateAtWork.add(Math.max(0, worked / MS - contender.ms()));
        nodes.add(decision.nodes());
        depth.add(decision.depth());
        finished += decision.finished() ? 1 : 0;
        spent += nanos / NANOS;
    }

    /** What the report says of it. */
    Map<String, Object> row() {
        Map<String, Object> row = new LinkedHashMap<>();
        row.put("solver", contender.solver().name());
        row.put("limit_ms", contender.ms() == 0 ? null : contender.ms());
        row.put("decisions", ms.size());
        if (!measured()) {
            row.put("longer_than_ms", PATIENCE_MS);
            return row;
        }
        row.putAll(ms().row("ms"));
        row.putAll(work().row("cpu_ms"));
        if (contender.ms() > 0) {
            row.putAll(late().row("late_ms"));
            row.putAll(lateAtWork().row("late_cpu_ms"));
        }
        row.put("median_nodes", nodes().median());
        row.put("median_depth", depth().median());
        row.put("median_bytes", bytes().median());
        row.put("finished_share", (double) finished / ms.size());
        return row;
    }

    Contender contender() {
        return contender;
    }

    /** Whether there is anything to report: not if it took too long to be tried without a limit. */
    boolean measured() {
        return !ms.isEmpty();
    }

    int decisions() {
        return ms.size();
    }

    /** Milliseconds. */
    Spread ms() {
        return new Spread(ms);
    }

    /** Milliseconds on a processor: what is left if other programs are not counted. */
    Spread work() {
        return new Spread(work);
    }

    /** Milliseconds beyond the limit. */
    Spread late() {
        return new Spread(late);
    }

    /** The same without the time in which the thread had no processor: at least so much is the contender's doing. */
    Spread lateAtWork() {
        return new Spread(lateAtWork);
    }

    Spread nodes() {
        return new Spread(nodes);
    }

    Spread depth() {
        return new Spread(depth);
    }

    /** Allocated by a decision. */
    Spread bytes() {
        return new Spread(bytes);
    }
}
