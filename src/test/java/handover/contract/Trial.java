package handover.contract;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.HandoverDomain;
import handover.domain.HandoverModel;
import handover.domain.HandoverObservationFunction;
import handover.domain.HandoverState;
import handover.domain.PickType;
import handover.domain.Task;
import handover.io.DomainFiles;
import handover.math.Simplex;
import handover.solver.Deadline;
import handover.solver.Decision;
import handover.solver.Policy;
import handover.solver.Solver;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.random.RandomGenerator;

/** A solver on a domain, with beliefs to decide at; fixed seeds. */
final class Trial {
    private static final int EPISODES = 3;
    private static final int STEPS = 5;
    private static final long SEED = 20261122;

    final Solver solver;
    final HandoverDomain domain;
    final List<HandoverBelief> beliefs;

    Trial(Solver solver, String domain) {
        this.solver = solver;
        this.domain = DomainFiles.load(domain);
        this.beliefs = beliefs(this.domain);
    }

    /** A policy that has decided nothing yet. */
    Policy policy() {
        return solver.solve(domain, new SplittableRandom(7));
    }

    /** A decision that may take as long as it wants. */
    static Decision decide(Policy policy, HandoverBelief belief, long seed) {
        return policy.decide(belief, Deadline.NONE, new SplittableRandom(seed));
    }

    /**
     * Beliefs of random episodes in which picks are often gone on with; certain ones, with the human certain of the same and of
     * something else; and tables of which one object, and all but one, are gone.
     */
    private static List<HandoverBelief> beliefs(HandoverDomain domain) {
        RandomGenerator random = new SplittableRandom(SEED);
        List<HandoverBelief> all = new ArrayList<>();
        for (int e = 0; e < EPISODES; e++) {
            episode(domain, random, all);
        }
        int n = domain.start().size();
        Task start = domain.task(domain.start());
        all.add(HandoverBelief.of(start, Simplex.vertex(n, 0), Simplex.vertex(n, 0)));
        all.add(HandoverBelief.of(start, Simplex.vertex(n, 0), Simplex.vertex(n, n - 1)));
        if (n > 1) {
            Task fewer = domain.task(domain.start().without(0));
            all.add(HandoverBelief.of(fewer, Simplex.uniform(n - 1), Simplex.uniform(n - 1)));
        }
        Task one = domain.task(domain.scene(domain.start().objects().subList(0, 1)));
        all.add(HandoverBelief.of(one, new double[] {1}, new double[] {1}));
        return all;
    }

    private static void episode(HandoverDomain domain, RandomGenerator random, List<HandoverBelief> all) {
        HandoverModel model = new HandoverModel(domain, random);
        HandoverObservationFunction senses = new HandoverObservationFunction(domain, random);
        int wanted = Simplex.sample(domain.prior(domain.start()), domain.start().size(), random);
        HandoverState state = domain.initialState(domain.start().objects().get(wanted).name());
        HandoverBelief belief = HandoverBelief.initial(domain);
        for (int k = 0; k < STEPS && !belief.task().done(); k++) {
            all.add(belief);
            Act act = next(belief.task(), random);
            state = (HandoverState) model.sample(state, act).op;
            belief = belief.after(act).given(senses.sample(state, act));
        }
    }

    private static Act next(Task task, RandomGenerator random) {
        return task.target() != null && random.nextInt(3) > 0 ? Act.of(PickType.VERB, task.target())
                : task.legalActs().get(random.nextInt(task.legalActs().size())).act();
    }
}
