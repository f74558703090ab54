package handover.cli;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.ActModel;
import handover.domain.HandoverDomain;
import handover.domain.HandoverModel;
import handover.domain.HandoverObservationFunction;
import handover.domain.HandoverState;
import handover.math.Simplex;
import handover.math.Streams;
import handover.simulation.EpisodeRunner;
import handover.solver.Deadline;
import handover.solver.Heuristic;
import handover.solver.Policy;
import java.util.ArrayList;
import java.util.List;
import java.util.random.RandomGenerator;

/**
 * Beliefs before the decisions of episodes in which the robot half the time goes by the rule of thumb and half the time
 * communicates at random: from not knowing to being sure, with and without a pick under way.
 */
final class BenchBeliefs {
    private BenchBeliefs() {}

    /** So many beliefs, the same for the same seed. */
    static List<HandoverBelief> of(HandoverDomain domain, int count, long seed) {
        RandomGenerator random = Streams.of(seed, "bench", 0);
        HandoverModel model = new HandoverModel(domain, random);
        HandoverObservationFunction senses = new HandoverObservationFunction(domain, random);
        Policy rule = new Heuristic().solve(domain, random);
        List<HandoverBelief> all = new ArrayList<>();
        while (all.size() < count) {
            double[] prior = domain.prior(domain.start());
            int wanted = Simplex.sample(prior, prior.length, random);
            HandoverState state = domain.initialState(domain.start().objects().get(wanted).name());
            HandoverBelief belief = HandoverBelief.initial(domain);
            for (int k = 0; k < EpisodeRunner.STEP_LIMIT && !belief.task().done() && all.size() < count; k++) {
                all.add(belief);
                Act act = random.nextBoolean() ? rule.decide(belief, Deadline.NONE, random).act() : anyButPick(belief, random);
                state = (HandoverState) model.sample(state, act).op;
                belief = belief.after(act).given(senses.sample(state, act));
            }
        }
        return all;
    }

    private static Act anyButPick(HandoverBelief belief, RandomGenerator random) {
        List<ActModel> quiet = belief.task().legalActs().stream().filter(m -> !m.isPick()).toList();
        return quiet.get(random.nextInt(quiet.size())).act();
    }
}
