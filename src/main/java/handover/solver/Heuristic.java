package handover.solver;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.DirectedType;
import handover.domain.HandoverDomain;
import handover.math.Simplex;
import java.util.random.RandomGenerator;

/**
 * The rule of thumb: hands over when sure enough ({@link PickWhenSure}); else points at the likeliest object if that is half as
 * likely again as one of N at random (p &gt;= 1.5/N); else waits.
 */
public record Heuristic() implements Solver {
    private static final double LIKELIER_THAN_CHANCE = 1.5;

    @Override
    public String name() {
        return "heuristic";
    }

    @Override
    public Policy solve(HandoverDomain domain, RandomGenerator random) {
        return (belief, deadline, chance) -> Decision.of(choose(belief));
    }

    private static Act choose(HandoverBelief belief) {
        Act pick = PickWhenSure.pick(belief);
        if (pick != null) {
            return pick;
        }
        double[] b = belief.probabilities();
        int x = Simplex.argmax(b, b.length);
        Act point = Act.of(DirectedType.POINT, belief.scene().objects().get(x).name());
        boolean worthIt = b[x] >= LIKELIER_THAN_CHANCE / b.length && belief.scene().model(point) != null;
        return worthIt ? point : Act.WAIT;
    }
}
