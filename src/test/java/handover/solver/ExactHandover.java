package handover.solver;

import burlap.mdp.singleagent.model.TransitionProb;
import handover.domain.Act;
import handover.domain.ActModel;
import handover.domain.Answer;
import handover.domain.HandoverDomain;
import handover.domain.HandoverModel;
import handover.domain.HandoverObservationFunction;
import handover.domain.HandoverState;
import handover.domain.Observation;
import handover.domain.PickSignal;
import handover.domain.Speech;
import handover.domain.Utterance;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Exact finite-horizon values by enumeration of states and observations through the BURLAP view alone: an oracle that
 * shares no code with the search. For domains without gestures and with one word at a time.
 */
final class ExactHandover {
    private final HandoverDomain domain;
    private final HandoverModel model;
    private final HandoverObservationFunction senses;
    private final List<Observation> observations = new ArrayList<>();

    ExactHandover(HandoverDomain domain) {
        this.domain = domain;
        this.model = new HandoverModel(domain, null);
        this.senses = new HandoverObservationFunction(domain, null);
        for (PickSignal signal : PickSignal.values()) {
            for (Answer answer : Answer.values()) {
                observations.add(observation(answer, List.of(), signal));
                domain.vocabulary().words().forEach(w -> observations.add(observation(answer, List.of(w), signal)));
            }
        }
    }

    private static Observation observation(Answer answer, List<String> words, PickSignal signal) {
        boolean silent = answer == Answer.NONE && words.isEmpty();
        return new Observation(silent ? null : Speech.of(new Utterance(answer, words, List.of(), List.of())), null, signal);
    }

    /** Value of an act at a belief, looking {@code horizon} acts ahead. */
    double q(Map<HandoverState, Double> belief, Act act, int horizon) {
        double reward = 0;
        Map<HandoverState, Double> predicted = new LinkedHashMap<>();
        for (Map.Entry<HandoverState, Double> e : belief.entrySet()) {
            for (TransitionProb t : model.transitions(e.getKey(), act)) {
                reward += e.getValue() * t.p * t.eo.r;
                predicted.merge((HandoverState) t.eo.op, e.getValue() * t.p, Double::sum);
            }
        }
        double future = 0;
        for (Observation o : observations) {
            Map<HandoverState, Double> posterior = new LinkedHashMap<>();
            double p = 0;
            for (Map.Entry<HandoverState, Double> e : predicted.entrySet()) {
                double joint = e.getValue() * senses.probability(o, e.getKey(), act);
                if (joint > 0) {
                    posterior.put(e.getKey(), joint);
                    p += joint;
                }
            }
            if (p > 0 && horizon > 1) {
                double z = p;
                posterior.replaceAll((s, joint) -> joint / z);
                future += p * v(posterior, horizon - 1);
            }
        }
        return reward + domain.discount() * future;
    }

    private double v(Map<HandoverState, Double> belief, int horizon) {
        HandoverState any = belief.keySet().iterator().next();
        if (any.task().done()) {
            return 0;
        }
        double best = Double.NEGATIVE_INFINITY;
        for (ActModel m : any.task().scene().acts()) {
            best = Math.max(best, q(belief, m.act(), horizon));
        }
        return best;
    }

    /** The belief over states that share what is known. */
    static Map<HandoverState, Double> belief(handover.belief.HandoverBelief b) {
        Map<HandoverState, Double> all = new LinkedHashMap<>();
        b.nonZeroBeliefs().forEach(s -> all.put((HandoverState) s.s, s.belief));
        return all;
    }
}
