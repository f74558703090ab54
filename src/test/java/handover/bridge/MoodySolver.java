package handover.bridge;

import handover.domain.Act;
import handover.domain.HandoverDomain;
import handover.math.Simplex;
import handover.solver.Decision;
import handover.solver.Policy;
import handover.solver.Solver;
import java.util.Map;
import java.util.concurrent.locks.LockSupport;
import java.util.random.RandomGenerator;

/**
 * Breaks if the first object is the likeliest, thinks until its deadline if it is the second, finds no number if it is the
 * third. Public as the bridge makes it by its name.
 */
public final class MoodySolver implements Solver {
    @Override
    public String name() {
        return "moody";
    }

    @Override
    public Policy solve(HandoverDomain domain, RandomGenerator random) {
        return (belief, deadline, chance) -> {
            double[] b = belief.probabilities();
            int likeliest = Simplex.argmax(b, b.length);
            if (b[likeliest] < 0.5) {
                return Decision.of(Act.WAIT);
            } else if (likeliest == 0) {
                throw new IllegalStateException("broken on purpose");
            } else if (likeliest == 2) {
                return new Decision(Act.WAIT, Map.of(Act.WAIT, Double.NaN), 1, 1, true);
            }
            while (!deadline.passed()) {
                LockSupport.parkNanos(1_000_000);
            }
            return new Decision(Act.of("ASK", belief.scene().objects().get(likeliest).name()), Map.of(), 1, 1, false);
        };
    }
}
