package handover.simulation;

import burlap.mdp.singleagent.environment.EnvironmentOutcome;
import handover.domain.Act;
import handover.domain.HandoverDomain;
import handover.domain.HandoverModel;
import handover.domain.HandoverObservationFunction;
import handover.domain.HandoverState;
import handover.domain.Observation;
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
    private HandoverState state;

    /** A person of {@code people}, in episode {@code episode} of the run {@code seed}. */
    World(HandoverDomain people, long seed, long episode) {
        nature = Streams.of(seed, "nature", episode);
        human = Streams.of(seed, "human", episode);
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

    /** Does an act; gives its reward. What people sense of it is then in {@link #state()}. */
    double step(Act act) {
        EnvironmentOutcome outcome = model.sample(state, act, nature, human);
        state = (HandoverState) outcome.op;
        return outcome.r;
    }

    /** What the person says and shows after an act. */
    Observation react(Act act) {
        return senses.sample(state, act, human);
    }
}
