package handover.tabular;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.solver.Deadline;
import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicInteger;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.LongRange;
import org.junit.jupiter.api.Test;

/** Bounds against the value by brute force over a finite horizon and what can come after it. */
class BoundedSearchTest {
    private static final double DISCOUNT = 0.4;
    private static final int HORIZON = 6;

    private static final class Brute {
        private final TabularPomdp m;

        Brute(TabularPomdp m) {
            this.m = m;
        }

        /** The best expected sum of the next rewards, over histories, from R(s, a, s', o) itself; b need not be normalised. */
        double value(double[] b, int horizon) {
            double best = horizon == 0 ? 0 : Double.NEGATIVE_INFINITY;
            for (int a = 0; horizon > 0 && a < m.acts().size(); a++) {
                double v = 0;
                for (int o = 0; o < m.observations().size(); o++) {
                    double[] next = new double[b.length];
                    for (int s = 0; s < b.length; s++) {
                        for (int k = 0; k < b.length; k++) {
                            double p = b[s] * m.transition(a, s, k) * m.observation(a, k, o);
                            next[k] += p;
                            v += p * m.reward(a, s, k, o);
                        }
                    }
                    v += m.discount() * value(next, horizon - 1);
                }
                best = Math.max(best, v);
            }
            return best;
        }

        double largestReward() {
            double most = 0;
            for (int a = 0; a < m.acts().size(); a++) {
                for (int s = 0; s < m.states().size(); s++) {
                    for (int k = 0; k < m.states().size(); k++) {
                        for (int o = 0; o < m.observations().size(); o++) {
                            most = Math.max(most, Math.abs(m.reward(a, s, k, o)));
                        }
                    }
                }
            }
            return most;
        }
    }

    @Property(tries = 150)
    void theBoundsEncloseTheValue(@ForAll @LongRange(min = 0, max = 1_000_000) long seed) {
        TabularPomdp m = RandomPomdps.of(seed, DISCOUNT);
        Brute brute = new Brute(m);
        double value = brute.value(m.start(), HORIZON);
        double tail = Math.pow(DISCOUNT, HORIZON) * brute.largestReward() / (1 - DISCOUNT) + 1e-9;
        Learned nothing = Learned.nothing(m);
        assertTrue(nothing.bounds().lower().value(m.start()) <= value + tail);
        assertTrue(nothing.bounds().upper().value(m.start()) >= value - tail);
        for (int most : new int[] {1, 10, 1000}) {
            BoundedSearch search = new BoundedSearch(m, nothing);
            search.search(m.start(), new BoundedSearch.Order(1e-9, false, most, seed), stopsAfter(400));
            assertTrue(search.lower() <= value + tail, "lower " + search.lower() + ", value " + value + "+-" + tail);
            assertTrue(search.upper() >= value - tail, "upper " + search.upper() + ", value " + value + "+-" + tail);
            assertTrue(search.lower() <= search.upper() + 1e-9);
        }
    }

    /** What was learnt from one start holds everywhere. */
    @Property(tries = 100)
    void whatWasLearntHoldsAtAnyBelief(@ForAll @LongRange(min = 0, max = 1_000_000) long seed) {
        TabularPomdp m = RandomPomdps.of(seed, DISCOUNT);
        Learned learned = PointBased.learn(m, 1e-3, 300, seed).learned();
        Brute brute = new Brute(m);
        double[] b = new double[m.states().size()];
        b[new SplittableRandom(seed).nextInt(b.length)] = 1;
        double tail = Math.pow(DISCOUNT, HORIZON) * brute.largestReward() / (1 - DISCOUNT) + 1e-9;
        double value = brute.value(b, HORIZON);
        assertTrue(learned.vectors().value(b) <= value + tail);
        BoundedSearch search = new BoundedSearch(m, learned);
        search.search(b, new BoundedSearch.Order(0, false, 200, seed), stopsAfter(50));
        assertTrue(search.lower() <= value + tail && search.upper() >= value - tail);
    }

    /** Also by a search that began with what an earlier one learnt, among which not all blind policies need be. */
    @Test
    void whatIsLearntTwiceIsNotForgotten() {
        int searched = 0;
        for (long seed = 0; seed < 300; seed++) {
            TabularPomdp m = RandomPomdps.of(seed, 0.9);
            BoundedSearch search = new BoundedSearch(m, PointBased.learn(m, 0.1, 20, seed).learned());
            search.search(m.start(), new BoundedSearch.Order(1e-6, false, 20, seed), Deadline.NONE);
            if (search.depth() > 0) {
                searched++;
                double learnt = search.learned().vectors().value(m.start());
                assertTrue(learnt >= search.lower() - 1e-9, "seed " + seed + ": " + learnt + " of " + search.lower());
            }
        }
        assertTrue(searched > 50, "only " + searched + " had something left to search");
    }

    @Property(tries = 100)
    void exactLookAheadIsBruteForce(@ForAll @LongRange(min = 0, max = 1_000_000) long seed) {
        TabularPomdp m = RandomPomdps.of(seed, 0.9);
        double[] q = new double[m.acts().size()];
        assertTrue(new LookAhead(m).values(m.start(), 4, Deadline.NONE, q));
        assertEquals(new Brute(m).value(m.start(), 4), Arrays.stream(q).max().orElseThrow(), 1e-8);
    }

    @Property(tries = 60)
    void boundsOnlyClose(@ForAll @LongRange(min = 0, max = 1_000_000) long seed) {
        TabularPomdp m = RandomPomdps.of(seed, 0.95);
        BoundedSearch search = new BoundedSearch(m, Learned.nothing(m));
        double lower = Double.NEGATIVE_INFINITY;
        double upper = Double.POSITIVE_INFINITY;
        for (int checks : new int[] {1, 2, 4, 8, 16, 32, 64}) {
            search.search(m.start(), new BoundedSearch.Order(1e-6, false, 5000, seed), stopsAfter(checks));
            assertTrue(search.lower() >= lower && search.upper() <= upper, "with " + checks + " checks of the deadline");
            lower = search.lower();
            upper = search.upper();
        }
    }

    @Property(tries = 100)
    void anUnforeseenObservationOnlyMovesTheBeliefOn(@ForAll @LongRange(min = 0, max = 1_000_000) long seed) {
        TabularPomdp m = RandomPomdps.of(seed, 0.9);
        for (int o = 0; o < m.observations().size(); o++) {
            double[] predicted = new double[m.states().size()];
            m.predict(m.start(), 0, predicted);
            double p = 0;
            for (int s = 0; s < predicted.length; s++) {
                p += predicted[s] * m.observation(0, s, o);
            }
            TabularBelief after = TabularBelief.start(m).after(m, 0, o);
            assertEquals(p > 0 ? 0 : 1, after.unforeseen());
            if (p == 0) {
                assertArrayEquals(predicted, after.probabilities());
            }
            assertEquals(1, Arrays.stream(after.probabilities()).sum(), 1e-9);
        }
    }

    private static Deadline stopsAfter(int checks) {
        AtomicInteger left = new AtomicInteger(checks);
        return () -> left.decrementAndGet() < 0;
    }

    /** Where few beliefs can be reached, the bounds close in on the value up to rounding, and then it stops. */
    @Property(tries = 20)
    void aGapOfNothingEnds(@ForAll @LongRange(min = 1, max = 1000) long seed) {
        TabularPomdp m = RandomPomdps.of(seed, 0.9);
        BoundedSearch search = new BoundedSearch(m, Learned.nothing(m));
        AtomicInteger checks = new AtomicInteger();
        search.search(m.start(), new BoundedSearch.Order(0, false, 2000, seed), () -> checks.incrementAndGet() > 100_000);
        assertFalse(search.stopped());
    }
}
