package handover.solver;

import handover.domain.ActEffect;
import handover.domain.HandoverDomain;
import handover.domain.Scene;
import handover.domain.Task;
import handover.math.Simplex;
import java.util.Arrays;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.IntStream;

/** Upper bounds on what acts at one table are worth, by which searches leave out what cannot be the best. Immutable. */
final class UpperBounds {
    private final HandoverDomain domain;
    private final int n;
    /** At most paid for all increments of a pick, without their match reward. */
    private final double pricePerPick;
    /** Expected discounted number of increments of a pick. */
    private final double increments;
    /** The discount of a pick's outcome. */
    private final double lastDiscount;
    /** At most earned by any acts from some belief on, and after an object was handed over. */
    private final double most;
    private final double mostAfterHandover;
    private final double rightPick;
    private final double wrongPick;

    /**
     * @param picks by object, the act that reaches for it
     * @param wrongInARow after so many wrong objects the leaves only wait
     * @param waiting the value of waiting for ever, by the match reward of a step
     * @param afterHandover what leaves are worth at most after an object was handed over
     */
    UpperBounds(Scene scene, int[] picks, int wrongInARow, DoubleUnaryOperator waiting, double afterHandover) {
        domain = scene.domain();
        n = scene.size();
        Task start = domain.task(scene);
        double gamma = domain.discount();
        double price = Arrays.stream(picks).mapToDouble(k -> start.effect(k).reward()).max().orElseThrow();
        increments = PickPrice.prices(domain.pickRule(), gamma);
        pricePerPick = price * increments;
        lastDiscount = PickPrice.outcome(domain.pickRule(), gamma);
        double match = IntStream.range(0, n).mapToDouble(i -> domain.matchBound(Simplex.vertex(n, i), n)).max().orElseThrow();
        double act = scene.acts().stream().mapToDouble(m -> start.effect(m.index()).reward()).max().orElseThrow();
        double steps = Math.max(0, match + act + Math.max(0, domain.spec().rewards().annoyance())) / (1 - gamma);
        double handover = Math.max(0, domain.pickReward(true));
        most = domain.pickReward(false) > 0 ? Double.POSITIVE_INFINITY : steps + domain.spec().handovers() * handover;
        mostAfterHandover = domain.spec().handovers() == 1 ? 0 : most - handover;
        rightPick = domain.pickReward(true) + gamma * Math.max(0, afterHandover);
        double perPick = Math.max(0, increments * (price + match));
        double best = Math.max(0, waiting.applyAsDouble(match));
        for (int k = 0; k < wrongInARow; k++) {
            best = Math.max(best, perPick + Math.max(Math.max(0, rightPick), domain.pickReward(false) + gamma * best));
        }
        wrongPick = domain.pickReward(false) + gamma * best;
    }

    /** On the match reward of a step, whatever the human expects. */
    double match(SearchBelief b) {
        if (Double.isNaN(b.matchBound)) {
            b.matchBound = domain.matchBound(b.p, n);
        }
        return b.matchBound;
    }

    /** On an act, however far the search looks after it. */
    double act(SearchBelief b, ActEffect effect) {
        if (most == Double.POSITIVE_INFINITY) {
            return most;
        }
        double now = effect.reward() + match(b);
        double onward = domain.discount() * most;
        if (!effect.completes()) {
            return now + onward;
        }
        double right = b.p[effect.model().target()];
        double outcome = domain.expectedPickReward(right) + right * domain.discount() * mostAfterHandover + (1 - right) * onward;
        return now + effect.advance() * outcome + (1 - effect.advance()) * onward;
    }

    /** On what a completed pick and the leaf after it are worth. */
    double outcome(double right) {
        return right * rightPick + (1 - right) * wrongPick;
    }

    /** On handing over an object with nothing done of it: what its increments cost, and an outcome that is worth so much. */
    double pick(SearchBelief b, double outcome) {
        return pricePerPick + increments * match(b) + lastDiscount * outcome;
    }

    /** On reaching for an object until the pick completes, whatever was done of it. */
    double reaching(SearchBelief b, int x) {
        double outcome = outcome(b.p[x]);
        return Math.max(0, pricePerPick + increments * match(b)) + Math.max(outcome, lastDiscount * outcome);
    }
}
