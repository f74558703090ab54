package handover.simulation;

import burlap.mdp.singleagent.environment.EnvironmentOutcome;
import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.HandoverDomain;
import handover.domain.HandoverModel;
import handover.domain.HandoverObservationFunction;
import handover.domain.HandoverState;
import handover.domain.Observation;
import handover.domain.Speech;
import handover.domain.Utterance;
import handover.domain.Vocabulary;
import handover.math.Simplex;
import handover.math.Streams;
import java.util.random.RandomGenerator;

/**
 * What really happens in one simulated episode: a person with parameters of their own, who wants something, sees what the
 * robot does, and reacts. Used by one thread.
 */
final class World {
    private final HandoverModel model;
    private final HandoverObservationFunction senses;
    private final RandomGenerator nature;
    private final RandomGenerator human;
    private final Vocabulary vocabulary;
    private HandoverState state;

    /** A person of {@code people}, in episode {@code episode} of the run {@code seed}. */
    World(HandoverDomain people, long seed, long episode) {
        nature = Streams.of(seed, "nature", episode);
        human = Streams.of(seed, "human", episode);
        vocabulary = people.vocabulary();
        model = new HandoverModel(people, nature);
        senses = new HandoverObservationFunction(people, human);
        double[] prior = people.prior(people.start());
        state = new HandoverState(Simplex.sample(prior, prior.length, nature), people.task(people.start()),
                Simplex.uniform(prior.length));
    }

    HandoverState state() {
        return state;
    }

    /** The name of what the human wants, empty if nothing is left. */
    String wanted() {
        return state.wanted() < 0 ? "" : state.task().scene().objects().get(state.wanted()).name();
    }

    /**
     * Does an act; gives its reward, with the part that depends on what the robot believes.
     *
     * @param predicted the robot's belief when the act starts
     */
    double step(Act act, HandoverBelief predicted) {
        double reward = step(act);
        return predicted.domain().beliefDependentReward() ? reward + predicted.matchReward() : reward;
    }

    /** Does an act; gives its reward as of the states that really are. What people sense of it is then in {@link #state()}. */
    double step(Act act) {
        EnvironmentOutcome outcome = model.sample(state, act, nature, human);
        state = (HandoverState) outcome.op;
        return outcome.r;
    }

    /** What the person says and shows after an act. */
    Observation react(Act act) {
        return senses.sample(state, act, human);
    }

    /** The same to somebody who knows these words: words of these people that are not among them are unknown words. */
    Observation react(Act act, Vocabulary listener) {
        Observation o = react(act);
        if (o.speech() == null || vocabulary.words().equals(listener.words())) {
            return o;
        }
        Utterance said = o.speech().alternatives().get(0).utterance();
        return new Observation(Speech.of(said.text(), listener), o.gesture(), o.signal());
    }
}
