package handover.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import burlap.domain.singleagent.pomdp.tiger.TigerDomain;
import burlap.mdp.singleagent.pomdp.PODomain;
import handover.solver.Racing.Race;
import handover.tabular.TabularDomains;
import handover.tabular.TabularPomdp;
import handover.tabular.TabularSearch;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Races on BURLAP's Tiger (0 open left, 1 open right, 2 listen), against weighing every observation. */
class RacingTest {
    private static final double GAMMA = 0.95;

    private final TabularPomdp tiger = TabularDomains.of((PODomain) new TigerDomain().generateDomain(), GAMMA, null);
    private final double[] q = new double[3];

    /** The exact value of an act at P(tiger left) = p, written from the problem's definition; 0 acts are worth 0. */
    private static double exact(double p, int act, int horizon) {
        if (act != 2) {
            double wrong = act == 0 ? p : 1 - p;
            return 10 - 110 * wrong + GAMMA * exact(0.5, horizon - 1);
        }
        double left = 0.85 * p + 0.15 * (1 - p);
        return -1 + GAMMA * (left * exact(0.85 * p / left, horizon - 1) + (1 - left) * exact(0.15 * p / (1 - left), horizon - 1));
    }

    private static double exact(double p, int horizon) {
        return horizon == 0 ? 0 : Math.max(exact(p, 2, horizon), Math.max(exact(p, 0, horizon), exact(p, 1, horizon)));
    }

    private Racing<TabularSearch.Node> racing(TabularSearch mdp, Race... races) {
        return new Racing<>(mdp, List.of(races), 3);
    }

    /**
     * With 2,000 draws of two observations whose values differ by at most 20, the standard error is below 20 / 2 / sqrt(2,000)
     * = 0.22 even without strata: off by 1 is more than four of them (odds below 1e-4), the rest being the bias of H = 3 at C = 50.
     */
    @ParameterizedTest
    @CsvSource({"0.5,2", "0.7,2", "0.85,2", "0.5,3", "0.85,3"})
    void theWinnerAndItsValueAreThoseOfWeighingEverything(double p, int horizon) {
        TabularSearch mdp = new TabularSearch(tiger);
        int best = racing(mdp, new Race(horizon, 50, 2000, 1e9)).run(mdp.belief(new double[] {p, 1 - p}), 5, Deadline.NONE, q);
        assertEquals(exact(p, horizon), exact(p, best, horizon), 1e-9, "the winner is a best act");
        assertEquals(exact(p, horizon), q[best], 1);
    }

    @Test
    void actsThatFallBehindGetNoMoreDraws() {
        TabularSearch mdp = new TabularSearch(tiger);
        double[] sure = {0.99, 0.01};
        Racing<TabularSearch.Node> raced = racing(mdp, new Race(2, 8, 1024, 0));
        assertEquals(1, raced.run(mdp.belief(sure), 1, Deadline.NONE, q), "the tiger is on the left");
        assertTrue(raced.finished());
        Racing<TabularSearch.Node> all = racing(mdp, new Race(2, 8, 1024, 1e9));
        all.run(mdp.belief(sure), 1, Deadline.NONE, q);
        assertTrue(raced.nodes() < all.nodes() / 10, raced.nodes() + " of " + all.nodes());
    }

    /** Three draws of each act see more than one act ahead, two may be pure luck. */
    @ParameterizedTest
    @CsvSource({"6,1", "8,1", "9,2", "24,2"})
    void aFirstRaceThatIsCutOffCountsFromThreeDrawsOn(int allowed, int depth) {
        TabularSearch mdp = new TabularSearch(tiger);
        Racing<TabularSearch.Node> racing = racing(mdp, new Race(2, 8, 64, 1e9));
        AtomicInteger checks = new AtomicInteger();
        assertEquals(2, racing.run(mdp.belief(new double[] {0.5, 0.5}), 1, () -> checks.incrementAndGet() > allowed, q));
        assertEquals(depth, racing.depth());
        assertFalse(racing.finished());
    }

    @Test
    void aRaceThatIsCutOffLeavesTheAnswerOfTheOneBefore() {
        TabularSearch mdp = new TabularSearch(tiger);
        Racing<TabularSearch.Node> racing = racing(mdp, new Race(2, 8, 64, 1e9), new Race(3, 8, 64, 1e9));
        double[] b = {0.5, 0.5};
        assertEquals(2, racing.run(mdp.belief(b), 1, () -> true, q));
        assertEquals(1, racing.depth());
        assertFalse(racing.finished());
        AtomicInteger checks = new AtomicInteger();
        int allowed = 3 * 64 + 30;
        racing.run(mdp.belief(b), 1, () -> checks.incrementAndGet() > allowed, q);
        assertEquals(2, racing.depth(), "three acts, 64 draws: the second race was stopped after less than a batch");
        assertFalse(racing.finished());
        double[] two = q.clone();
        racing(mdp, new Race(2, 8, 64, 1e9)).run(mdp.belief(b), 1, Deadline.NONE, q);
        assertEquals(q[2], two[2], 0);
    }
}
