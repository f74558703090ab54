package handover.solver;

import burlap.mdp.core.state.State;
import burlap.mdp.singleagent.model.TransitionProb;
import burlap.mdp.singleagent.pomdp.beliefstate.EnumerableBeliefState.StateBelief;
import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.ActModel;
import handover.domain.Answer;
import handover.domain.HandoverDomain;
import handover.domain.HandoverModel;
import handover.domain.HandoverObservationFunction;
import handover.domain.HandoverState;
import handover.domain.Observation;
import handover.domain.Speech;
import handover.domain.Utterance;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;

/** Values of two acts by enumeration of states and observations: one word at a time, no gestures. */
final class NestedOracle {
    private NestedOracle() {}

    /** The value of an act and the best one after it. */
    static double q(HandoverDomain domain, HandoverBelief belief, Act act) {
        Map<State, Double> states = new HashMap<>();
        for (StateBelief s : belief.nonZeroBeliefs()) {
            states.merge(s.s, s.belief, Double::sum);
        }
        HandoverModel model = new HandoverModel(domain, new SplittableRandom(1));
        HandoverObservationFunction senses = new HandoverObservationFunction(domain, new SplittableRandom(1));
        double value = 0;
        Map<State, Double> next = new HashMap<>();
        for (Map.Entry<State, Double> e : states.entrySet()) {
            for (TransitionProb t : model.transitions(e.getKey(), act)) {
                value += e.getValue() * t.p * t.eo.r;
                if (!t.eo.terminated) {
                    next.merge(t.eo.op, e.getValue() * t.p, Double::sum);
                }
            }
        }
        Map<Object, List<Map.Entry<State, Double>>> known = new HashMap<>();
        next.entrySet().forEach(e -> known.computeIfAbsent(((HandoverState) e.getKey()).task(), k -> new ArrayList<>()).add(e));
        for (List<Map.Entry<State, Double>> group : known.values()) {
            for (Observation o : observations(domain, (HandoverState) group.get(0).getKey())) {
                Map<State, Double> posterior = new HashMap<>();
                group.forEach(e -> posterior.merge(e.getKey(), e.getValue() * senses.probability(o, e.getKey(), act), Double::sum));
                value += domain.discount() * best(model, posterior);
            }
        }
        return value;
    }

    private static double best(HandoverModel model, Map<State, Double> states) {
        double best = Double.NEGATIVE_INFINITY;
        for (ActModel a : ((HandoverState) states.keySet().iterator().next()).task().legalActs()) {
            double value = 0;
            for (Map.Entry<State, Double> e : states.entrySet()) {
                for (TransitionProb t : model.transitions(e.getKey(), a.act())) {
                    value += e.getValue() * t.p * t.eo.r;
                }
            }
            best = Math.max(best, value);
        }
        return best;
    }

    private static List<Observation> observations(HandoverDomain domain, HandoverState s) {
        List<Observation> all = new ArrayList<>();
        Answer answer = s.task().answer();
        all.add(new Observation(answer == Answer.NONE ? null : Speech.of(new Utterance(answer, List.of(), List.of(), List.of())), null,
                s.task().signal()));
        domain.vocabulary().words().forEach(w -> all.add(new Observation(
                Speech.of(new Utterance(answer, List.of(w), List.of(), List.of())), null, s.task().signal())));
        return all;
    }
}
