package my.lab;

import handover.domain.Act;
import handover.domain.HandoverDomain;
import handover.math.Simplex;
import handover.solver.Decision;
import handover.solver.Policy;
import handover.solver.Solver;
import java.util.random.RandomGenerator;

/** Asks about the likeliest object once, then hands over the likeliest, whatever the answer was. */
public record AskOnce() implements Solver {
    @Override
    public String name() {
        return "ask-once";
    }

    @Override
    public Policy solve(HandoverDomain domain, RandomGenerator random) {
        return (belief, deadline, chance) -> {
            double[] b = belief.probabilities();
            String likeliest = belief.scene().objects().get(Simplex.argmax(b, b.length)).name();
            boolean asked = belief.task().reference() != null;
            return Decision.of(Act.of(asked ? "PICK" : "ASK", likeliest));
        };
    }
}
