package handover.solver;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.Answer;
import handover.domain.AskType;
import handover.domain.HandoverDomain;
import handover.domain.PickType;
import handover.domain.Task;
import handover.math.Simplex;
import java.util.random.RandomGenerator;

/** Fixed feedback: asks about the likeliest object until the human says yes to it, then hands it over. */
public record Confirm() implements Solver {
    @Override
    public String name() {
        return "confirm";
    }

    @Override
    public Policy solve(HandoverDomain domain, RandomGenerator random) {
        return (belief, deadline, chance) -> Decision.of(choose(belief));
    }

    private static Act choose(HandoverBelief belief) {
        Task task = belief.task();
        if (task.target() != null) {
            return Act.of(PickType.VERB, task.target());
        }
        String likeliest = belief.scene().objects().get(Simplex.argmax(belief.probabilities(), belief.human().length)).name();
        Act ask = Act.of(AskType.VERB, likeliest);
        boolean confirmed = ask.equals(task.reference()) && task.answer() == Answer.YES;
        return confirmed ? Act.of(PickType.VERB, likeliest) : ask;
    }
}
