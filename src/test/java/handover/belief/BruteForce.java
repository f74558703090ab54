package handover.belief;

import burlap.mdp.singleagent.model.TransitionProb;
import handover.domain.Act;
import handover.domain.HandoverDomain;
import handover.domain.HandoverModel;
import handover.domain.HandoverObservationFunction;
import handover.domain.HandoverState;
import handover.domain.Observation;
import java.util.Arrays;
import java.util.Random;

/** Bayes' rule as BURLAP's own tabular filter applies it: every state, every transition, every likelihood. */
final class BruteForce {
    private BruteForce() {}

    /** Unnormalised posterior over what is wanted after a step; {@code size} objects are then on the table. */
    static double[] joint(HandoverBelief before, Act act, Observation o, int size) {
        HandoverDomain domain = before.domain();
        HandoverModel model = new HandoverModel(domain, new Random(0));
        HandoverObservationFunction likelihood = new HandoverObservationFunction(domain, new Random(0));
        double[] posterior = new double[size];
        for (int j = 0; j < before.probabilities().length; j++) {
            HandoverState s = new HandoverState(j, before.task(), before.human());
            for (TransitionProb t : model.transitions(s, act)) {
                HandoverState next = (HandoverState) t.eo.op;
                double p = before.probabilities()[j] * t.p * likelihood.probability(o, next, act);
                if (p > 0 && next.wanted() >= 0) {
                    posterior[next.wanted()] += p;
                }
            }
        }
        return posterior;
    }

    static double[] normalised(double[] joint) {
        double z = Arrays.stream(joint).sum();
        return Arrays.stream(joint).map(p -> p / z).toArray();
    }
}
