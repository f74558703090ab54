package handover.domain;

import burlap.mdp.core.action.Action;
import burlap.mdp.core.state.State;
import burlap.mdp.singleagent.pomdp.observations.ObservationFunction;
import java.util.List;
import java.util.random.RandomGenerator;

/**
 * p(o | s', a) of a {@link HandoverDomain}: scores an {@link Observation} (a density per steradian where there is a
 * gesture) and draws one. Answer and pick signal repeat what the state already holds. Thread safe except
 * {@link #sample(State, Action)}, which draws from the generator that was handed in.
 */
public final class HandoverObservationFunction implements ObservationFunction {
    private final HandoverDomain domain;
    private final RandomGenerator random;

    public HandoverObservationFunction(HandoverDomain domain, RandomGenerator random) {
        this.domain = domain;
        this.random = random;
    }

    @Override
    public double probability(State observation, State state, Action action) {
        Observation o = (Observation) observation;
        HandoverState s = HandoverState.of(state);
        if (o.signal() != s.task().signal()) {
            return 0;
        }
        if (s.task().done()) {
            return o.speech() == null && o.gesture() == null ? 1 : 0;
        }
        return speechProbability(o.speech(), s, typeOf(action, s)) * gestureDensity(o.gesture(), s, typeOf(action, s));
    }

    private double speechProbability(Speech speech, HandoverState s, ActType type) {
        if (speech == null) {
            return utteranceProbability(Utterance.SILENCE, s, type);
        }
        double p = 0;
        for (Speech.Alternative a : speech.alternatives()) {
            p += a.confidence() * utteranceProbability(a.utterance(), s, type);
        }
        return p;
    }

    private double utteranceProbability(Utterance said, HandoverState s, ActType type) {
        if (said.answer() != s.task().answer()) {
            return 0;
        }
        double rate = domain.contentRate(type, s.human()[s.wanted()]);
        double[] words = new double[s.human().length];
        HumanModel.addLogWords(s.task().scene(), reference(s), said, words);
        List<Double> counts = domain.spec().speech().wordCounts();
        int k = said.content().size();
        double count = k == 0 ? 1 - rate : k <= counts.size() ? rate * counts.get(k - 1) : 0;
        return count * Math.exp(words[s.wanted()]);
    }

    private double gestureDensity(Gesture gesture, HandoverState s, ActType type) {
        double rate = type.parameters().gestureRate();
        return gesture == null ? 1 - rate
                : rate * HumanModel.gestureDensities(s.task().scene(), gesture)[s.wanted()];
    }

    @Override
    public Observation sample(State state, Action action) {
        return sample(state, action, random);
    }

    /** What a human in this state says and shows. */
    public Observation sample(State state, Action action, RandomGenerator human) {
        HandoverState s = HandoverState.of(state);
        Task task = s.task();
        if (task.done()) {
            return new Observation(null, null, task.signal());
        }
        ActType type = typeOf(action, s);
        boolean speaks = human.nextDouble() < domain.contentRate(type, s.human()[s.wanted()]);
        List<String> words = speaks ? HumanModel.sampleWords(task.scene(), reference(s), s.wanted(), human) : List.of();
        boolean silent = !speaks && task.answer() == Answer.NONE;
        Speech speech = silent ? null : Speech.of(new Utterance(task.answer(), words, List.of(), List.of()));
        boolean points = human.nextDouble() < type.parameters().gestureRate();
        Gesture gesture = points ? HumanModel.sampleGesture(task.scene(), s.wanted(), human) : null;
        return new Observation(speech, gesture, task.signal());
    }

    private static ActModel reference(HandoverState s) {
        Act reference = s.seen().reference();
        return reference == null ? null : s.task().scene().model(reference);
    }

    private ActType typeOf(Action action, HandoverState s) {
        String verb = ((Act) action).verb();
        return domain.types().stream().filter(t -> t.verb().equals(verb)).findFirst()
                .orElseThrow(() -> new IllegalArgumentException(action + " is no act of this domain: " + s.task().scene()));
    }
}
