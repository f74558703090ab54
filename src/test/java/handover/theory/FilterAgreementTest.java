package handover.theory;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.ActModel;
import handover.domain.ActParameters;
import handover.domain.DomainSpec;
import handover.domain.Gesture;
import handover.domain.HandoverDomain;
import handover.domain.HumanModel;
import handover.domain.TableObject;
import handover.math.Vector3;
import handover.theory.Agent.Human;
import handover.theory.Agent.Robot;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The categorical level is the filter of {@code handover.belief}: h is beta, b is b, to 1e-12. */
class FilterAgreementTest {
    /** Four objects; the human never answers and speaks as often whatever is wanted, so that only gestures are evidence. */
    private static HandoverDomain domain(double tau) {
        List<TableObject> objects = List.of(object("cup", -0.3), object("can", -0.1), object("box", 0.1), object("jar", 0.3));
        return new HandoverDomain(DomainSpec.of("four", objects).with(s -> {
            s.tau = tau;
            s.acts.replaceAll((verb, a) -> new ActParameters(a.reward(), a.duration(), a.speechRate(), a.gestureRate(), 0, 0));
        }));
    }

    private static TableObject object(String name, double x) {
        return new TableObject(name, new Vector3(x, 0.6, 0), Map.of(name, 1.0, "thing", 2.0), null);
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 0.9})
    void equalsTheFilter(double tau) {
        HandoverDomain domain = domain(tau);
        SplittableRandom random = new SplittableRandom(8);
        List<ActModel> acts = domain.start().acts().stream().filter(a -> !a.isPick()).toList();
        HandoverBelief filter = HandoverBelief.initial(domain);
        Categorical<Robot> beta = Categorical.uniform(4);
        Categorical<Human> b = Categorical.uniform(4);
        Transition<Robot> own = Transition.stay(4, domain.spec().tauHuman());
        Transition<Human> wanted = Transition.stay(4, tau);
        for (int t = 0; t < 20; t++) {
            ActModel act = acts.get(random.nextInt(acts.size()));
            Gesture gesture = HumanModel.sampleGesture(domain.start(), random.nextInt(4), random);
            filter = filter.after(act.act()).saw(gesture);
            beta = beta.updated(own, act.act().equals(Act.WAIT) ? Message.nothing(4) : new Message<>(act.lambda()));
            b = b.updated(wanted, new Message<>(HumanModel.gestureDensities(domain.start(), gesture)));
            assertArrayEquals(filter.human(), beta.probabilities(), 1e-12);
            assertArrayEquals(filter.probabilities(), b.probabilities(), 1e-12);
        }
    }
}
