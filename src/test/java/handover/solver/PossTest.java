package handover.solver;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.ActModel;
import handover.domain.DomainSpec;
import handover.domain.HandoverDomain;
import handover.domain.Observation;
import handover.domain.PickSignal;
import handover.domain.Rewards;
import handover.domain.Speech;
import handover.domain.WrongPick;
import handover.contract.Unbounded;
import handover.io.DomainFiles;
import handover.math.MatchScore;
import java.lang.management.ManagementFactory;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** POSS on handover domains: exact values, pruning, determinism, deadlines. */
class PossTest {
    private static HandoverBelief later(HandoverDomain domain) {
        String first = domain.spec().objects().get(0).name();
        return HandoverBelief.initial(domain).after(Act.of("ASK", first))
                .given(new Observation(Speech.of("no", domain.vocabulary()), null, PickSignal.NONE));
    }

    private static DomainSpec scored(DomainSpec spec, MatchScore score) {
        return spec.with(s -> s.rewards = new Rewards(50, -150, -2, 1, score, 0.95));
    }

    /**
     * 2,000 observations for each of the 9 acts at the root, none at the last level: the standard error of a value is below
     * 45 / sqrt(2,000) = 1.0 even without strata, so that a miss by 2.5 has odds below 1e-4 for an unbiased search.
     */
    @ParameterizedTest
    @EnumSource(value = MatchScore.class, names = {"BRIER", "LOG", "LINEAR", "NONE"})
    void valuesApproachTheExactOnesOfTwoObjects(MatchScore score) {
        HandoverDomain domain = new HandoverDomain(scored(SmallHandover.spec(), score));
        ExactHandover exact = new ExactHandover(domain);
        for (HandoverBelief belief : List.of(HandoverBelief.initial(domain), later(domain))) {
            Decision decision = decide(new Poss(2, 2000, false), domain, belief, 3);
            for (ActModel m : domain.start().acts()) {
                assertEquals(exact.q(ExactHandover.belief(belief), m.act(), 2), decision.values().get(m.act()), 2.5,
                        m + " at " + belief);
            }
        }
    }

    /** Width 60, three acts ahead: the standard error is below 45 / sqrt(60) = 6 without strata, with them about 1. */
    @Test
    void valuesApproachTheExactOnesThreeActsAhead() {
        HandoverDomain domain = SmallHandover.domain();
        ExactHandover exact = new ExactHandover(domain);
        HandoverBelief belief = HandoverBelief.initial(domain);
        Decision decision = decide(new Poss(3, 60, false), domain, belief, 5);
        for (ActModel m : domain.start().acts()) {
            assertEquals(exact.q(ExactHandover.belief(belief), m.act(), 3), decision.values().get(m.act()), 4,
                    m.toString());
        }
    }

    @ParameterizedTest
    @EnumSource(WrongPick.class)
    void lookingOneActAheadIsExactForEveryWrongPickPolicy(WrongPick policy) {
        HandoverDomain domain = new HandoverDomain(SmallHandover.spec().with(s -> s.wrongPick = policy));
        HandoverBelief belief = later(domain);
        Decision decision = decide(new Poss(1, 1, false), domain, belief, 1);
        for (ActModel m : domain.start().acts()) {
            assertEquals(new ExactHandover(domain).q(ExactHandover.belief(belief), m.act(), 1),
                    decision.values().get(m.act()), 1e-12, m.toString());
        }
    }

    /** The bound only leaves out what cannot be the best: the same values to the last bit without it. */
    @ParameterizedTest
    @EnumSource(MatchScore.class)
    void pruningChangesNoValue(MatchScore score) {
        for (String name : List.of("bowls-and-spoons", "table-line-6", "bowls-incremental")) {
            for (int handovers : new int[] {1, 2}) {
                DomainSpec spec = scored(DomainFiles.read(name), score).with(s -> s.handovers = handovers);
                HandoverDomain domain = new HandoverDomain(spec);
                double[] pruned = new double[domain.start().acts().size()];
                double[] whole = pruned.clone();
                HandoverSearch mdp = new HandoverSearch(domain.start(), new ConcurrentHashMap<>());
                HandoverSearch.Node root = mdp.node().load(later(domain));
                new SparseSampling<>(mdp, 4, true).values(root, 2, 11, Deadline.NONE, pruned);
                new SparseSampling<>(new Unbounded<>(mdp), 4, true).values(root, 2, 11, Deadline.NONE, whole);
                assertArrayEquals(whole, pruned, 0, name + " " + handovers);
            }
        }
    }

    /** Rewards that make bounds infinite or leave nothing to discount. */
    @ParameterizedTest
    @CsvSource({"1,0.95", "60,0.95", "-100,0", "1,0"})
    void pruningChangesNoValueWhateverIsPaid(double wrong, double discount) {
        for (String name : List.of("bowls-and-spoons", "bowls-incremental")) {
            DomainSpec spec = DomainFiles.read(name).with(s -> {
                s.rewards = new Rewards(50, wrong, -0.5, 1, MatchScore.BRIER, discount);
                s.handovers = 2;
            });
            HandoverDomain domain = new HandoverDomain(spec);
            double[] pruned = new double[domain.start().acts().size()];
            double[] whole = pruned.clone();
            HandoverSearch mdp = new HandoverSearch(domain.start(), new ConcurrentHashMap<>());
            HandoverSearch.Node root = mdp.node().load(later(domain));
            new SparseSampling<>(mdp, 4, true).values(root, 2, 11, Deadline.NONE, pruned);
            new SparseSampling<>(new Unbounded<>(mdp), 4, true).values(root, 2, 11, Deadline.NONE, whole);
            assertArrayEquals(whole, pruned, 0, name);
        }
    }

    @Test
    void sameSeedSameDecisionWhateverWasDecidedBeforeAndOnAnyThread() {
        HandoverDomain domain = new HandoverDomain(DomainFiles.read("bowls-and-spoons"));
        Policy policy = new Poss(2, 8, true).solve(domain, new SplittableRandom(0));
        HandoverBelief start = HandoverBelief.initial(domain);
        Decision first = policy.decide(start, Deadline.NONE, new SplittableRandom(42));
        policy.decide(later(domain), Deadline.NONE, new SplittableRandom(1));
        assertEquals(first, policy.decide(start, Deadline.NONE, new SplittableRandom(42)));
        assertNotEquals(first.values(), policy.decide(start, Deadline.NONE, new SplittableRandom(43)).values());
        List<Decision> parallel = IntStream.range(0, 8).parallel()
                .mapToObj(k -> policy.decide(start, Deadline.NONE, new SplittableRandom(42))).toList();
        parallel.forEach(d -> assertEquals(first, d));
    }

    @Test
    void threadsChangeNothing() {
        HandoverDomain domain = new HandoverDomain(DomainFiles.read("table-line-6"));
        Decision alone = decide(new Poss(3, 3, true), domain, later(domain), 5);
        for (int threads : new int[] {2, 3, 100}) {
            assertEquals(alone, decide(new Poss(3, 3, true, threads), domain, later(domain), 5), threads + " threads");
        }
    }

    @Test
    void deepensUntilTheDeadlinePassesAndAlwaysDecides() {
        HandoverDomain domain = new HandoverDomain(DomainFiles.read("table-line-6"));
        Policy policy = new Poss(6, 5, true).solve(domain, new SplittableRandom(0));
        HandoverBelief belief = HandoverBelief.initial(domain);
        Decision passed = policy.decide(belief, () -> true, new SplittableRandom(1));
        assertEquals(1, passed.depth());
        assertFalse(passed.finished());
        AtomicInteger checks = new AtomicInteger();
        Decision cut = policy.decide(belief, () -> checks.incrementAndGet() > 40, new SplittableRandom(1));
        assertTrue(cut.depth() >= 2 && cut.depth() < 6, "depth " + cut.depth());
        assertEquals(decide(new Poss(2, 5, true), domain, belief, 1).values().keySet(), cut.values().keySet());
        cut.values().forEach((act, q) -> assertTrue(Double.isFinite(q), act + " " + q));
    }

    /** The deepest level that was finished gives the values, the same as without a deadline. */
    @Test
    void aDeadlineGivesTheValuesOfTheDeepestFinishedLevel() {
        HandoverDomain domain = new HandoverDomain(DomainFiles.read("bowls-and-spoons"));
        HandoverBelief belief = HandoverBelief.initial(domain);
        Decision unhurried = new Poss(2, 5, true).solve(domain, null)
                .decide(belief, () -> false, new SplittableRandom(9));
        assertEquals(decide(new Poss(2, 5, true), domain, belief, 9), unhurried);
        assertTrue(unhurried.finished());
    }

    /** A decision allocates its result, not its nodes: 130 times as many nodes, the same number of bytes within 1 kB. */
    @Test
    void nodesAllocateNothing() {
        assertEquals(bytes(new Poss(2, 2, true)), bytes(new Poss(3, 10, true)), 1024);
    }

    private static double bytes(Solver solver) {
        var threads = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
        HandoverDomain domain = new HandoverDomain(DomainFiles.read("bowls-and-spoons"));
        Policy policy = solver.solve(domain, new SplittableRandom(0));
        HandoverBelief belief = later(domain);
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < 10; k++) {
            long before = threads.getThreadAllocatedBytes(Thread.currentThread().getId());
            policy.decide(belief, Deadline.NONE, new SplittableRandom(1));
            least = Math.min(least, threads.getThreadAllocatedBytes(Thread.currentThread().getId()) - before);
        }
        return least;
    }

    @Test
    void refusesAHorizonOrWidthBelowOne() {
        assertThrows(IllegalArgumentException.class, () -> new Poss(0, 5, true));
        assertThrows(IllegalArgumentException.class, () -> new Poss(3, 0, true));
        assertThrows(IllegalArgumentException.class, () -> new Poss(3, 5, true, 0));
    }

    private static Decision decide(Solver solver, HandoverDomain domain, HandoverBelief belief, long seed) {
        return solver.solve(domain, new SplittableRandom(0)).decide(belief, Deadline.NONE, new SplittableRandom(seed));
    }
}
