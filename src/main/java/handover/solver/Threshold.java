package handover.solver;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.HandoverDomain;
import handover.domain.PickType;
import handover.math.Simplex;
import java.util.random.RandomGenerator;

/**
 * No feedback: waits until one object is likely enough and hands it over.
 *
 * @param probability at which the likeliest object is handed over, in [0, 1]
 */
public record Threshold(double probability) implements Solver {
    /** Throws {@link IllegalArgumentException} for anything but a probability. */
    public Threshold {
        if (!(probability >= 0 && probability <= 1)) {
            throw new IllegalArgumentException("threshold: expected p in [0, 1], got " + probability);
        }
    }

    @Override
    public String name() {
        return "threshold:p=" + probability;
    }

    @Override
    public Policy solve(HandoverDomain domain, RandomGenerator random) {
        return (belief, deadline, chance) -> Decision.of(choose(belief));
    }

    private Act choose(HandoverBelief belief) {
        double[] b = belief.probabilities();
        int x = Simplex.argmax(b, b.length);
        return b[x] >= probability ? Act.of(PickType.VERB, belief.scene().objects().get(x).name()) : Act.WAIT;
    }
}
