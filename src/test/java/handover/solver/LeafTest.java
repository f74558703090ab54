package handover.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.DomainSpec;
import handover.domain.HandoverDomain;
import handover.domain.IncrementalPickDomain;
import handover.domain.Rewards;
import handover.domain.WrongPick;
import handover.math.MatchScore;
import handover.math.Simplex;
import java.util.SplittableRandom;
import java.util.concurrent.ConcurrentHashMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What leaves are worth, by hand: two objects, no match reward, discount .95. */
class LeafTest {
    private static final double GAMMA = 0.95;
    private static final double WAITING = -1 / (1 - GAMMA);

    private static DomainSpec spec() {
        return SmallHandover.spec().with(s -> s.rewards = new Rewards(50, -150, -2, 1, MatchScore.NONE, GAMMA));
    }

    /** The value of the leaf after a WAIT at which object 0 is wanted with probability p. */
    private static double leaf(HandoverDomain domain, double p) {
        HandoverSearch search = new HandoverSearch(domain.start(), new ConcurrentHashMap<>());
        double[] b = {p, 1 - p};
        HandoverBelief belief = HandoverBelief.of(domain.task(domain.start()), b, Simplex.uniform(2));
        HandoverSearch.Node predicted = search.node();
        search.start(search.node().load(belief), domain.start().model(Act.WAIT).index(), predicted);
        return search.leaf(predicted);
    }

    private static double committing(double p) {
        return -1 + 50 * p - 150 * (1 - p) + GAMMA * (1 - p) * Math.max(WAITING, -1 + 50);
    }

    /**
     * Asks the likelier one (r = .95, e = .1), at most four times, and hands over on yes; repeating a question costs 2 more.
     *
     * @param last the object that was asked about before, -1 if none
     */
    private static double asking(double[] w, int left, int last) {
        double mass = w[0] + w[1];
        if (left == 0 || mass <= 0.02) {
            return mass * WAITING;
        }
        int x = w[1] > w[0] ? 1 : 0;
        double yesRight = w[x] * 0.95 * 0.9;
        double yesWrong = w[1 - x] * 0.95 * 0.1;
        double picks = (yesRight + yesWrong) * -1 + yesRight * 50 + yesWrong * (-150 + GAMMA * WAITING);
        double[] rest = {w[0] - (x == 0 ? yesRight : yesWrong), w[1] - (x == 1 ? yesRight : yesWrong)};
        return mass * (x == last ? -4.5 : -2.5) + GAMMA * picks + GAMMA * asking(rest, left - 1, x);
    }

    @ParameterizedTest
    @CsvSource({"1", "0.99", "0.95", "0.9", "0.8", "0.6", "0.5"})
    void theBestOfHandingOverAskingAndWaiting(double p) {
        double expected = Math.max(WAITING, Math.max(committing(p), asking(new double[] {p, 1 - p}, 4, -1)));
        assertEquals(expected, leaf(new HandoverDomain(spec()), p), 1e-9);
    }

    @Test
    void aTerminalWrongPickIsWorthNothingAfterwards() {
        HandoverDomain domain = new HandoverDomain(spec().with(s -> s.wrongPick = WrongPick.TERMINAL));
        assertEquals(-1 + 0.99 * 50 - 0.01 * 150, leaf(domain, 0.99), 1e-9);
    }

    /** Two handovers: after the first the best of waiting and asking in turn, for a wish of which nothing is known. */
    @Test
    void whatComesAfterAHandoverCounts() {
        HandoverDomain domain = new HandoverDomain(spec().with(s -> s.handovers = 2));
        double next = Math.max(WAITING, asking(new double[] {0.5, 0.5}, 4, -1));
        assertEquals(-1 + 50 + GAMMA * next, leaf(domain, 1), 1e-9);
    }

    /** Three increments: the price three times, the outcome with the discount of two steps. */
    @Test
    void incrementsAreAllPaidFor() {
        HandoverDomain domain = new IncrementalPickDomain(spec());
        assertEquals(-1 - GAMMA - GAMMA * GAMMA + GAMMA * GAMMA * 50, leaf(domain, 1), 1e-9);
    }

    /** With H = 1 &lt; K = 3 a pick is started all the same, because the leaf values what it leads to. */
    @Test
    void picksAreStartedBeyondTheHorizon() {
        HandoverDomain domain = new IncrementalPickDomain(spec());
        HandoverBelief sure = HandoverBelief.of(domain.task(domain.start()), new double[] {1, 0}, Simplex.uniform(2));
        assertEquals(Act.of("PICK", "cup"), new Poss(1, 1, true).solve(domain, new SplittableRandom(1))
                .decide(sure, Deadline.NONE, new SplittableRandom(1)).act());
    }

    /** A wish that may move makes waiting worse, not better: with tau = .9 a sure belief is acted on at once. */
    @Test
    void aMovingWishIsNoReasonToPutThingsOff() {
        HandoverDomain domain = new HandoverDomain(spec().with(s -> s.tau = 0.9));
        assertEquals(-1 + 50 * 0.82 - 150 * 0.18, leaf(domain, 1), 6, "0.9 after the wait, 0.82 when the pick completes");
        HandoverBelief sure = HandoverBelief.of(domain.task(domain.start()), new double[] {1, 0}, Simplex.uniform(2));
        assertEquals(Act.of("PICK", "cup"), new Poss(2, 10, true).solve(domain, new SplittableRandom(1))
                .decide(sure, Deadline.NONE, new SplittableRandom(1)).act());
    }

    /** A leaf is worth the same whichever act was looked at before; asking again costs, asking after another act does not. */
    @Test
    void aLeafDoesNotDependOnTheOrderOfActs() {
        HandoverDomain domain = new HandoverDomain(spec());
        HandoverSearch search = new HandoverSearch(domain.start());
        HandoverBelief belief = HandoverBelief.of(domain.task(domain.start()), new double[] {0.6, 0.4}, Simplex.uniform(2));
        HandoverSearch.Node root = search.root(belief);
        double[] inOrder = new double[domain.start().acts().size()];
        for (int a = 0; a < inOrder.length; a++) {
            inOrder[a] = leafAfter(search, root, a);
        }
        for (int a = inOrder.length - 1; a >= 0; a--) {
            HandoverSearch alone = new HandoverSearch(domain.start());
            assertEquals(leafAfter(alone, alone.root(belief), a), inOrder[a], 0, domain.start().acts().get(a).toString());
        }
        int ask = domain.start().model(Act.of("ASK", "cup")).index();
        int wait = domain.start().model(Act.WAIT).index();
        assertEquals(inOrder[wait] - 2, inOrder[ask], 1e-9, "the annoyance of asking the same again");
    }

    private static double leafAfter(HandoverSearch search, HandoverSearch.Node root, int act) {
        HandoverSearch.Node predicted = search.node();
        search.start(root, act, predicted);
        return search.leaf(predicted);
    }
}
