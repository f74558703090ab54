package handover.theory;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.ActModel;
import handover.domain.ActParameters;
import handover.domain.ActType;
import handover.domain.Answer;
import handover.domain.DomainSpec;
import handover.domain.Gesture;
import handover.domain.HandoverDomain;
import handover.domain.HumanModel;
import handover.domain.PerceptionParameters;
import handover.domain.Percept;
import handover.domain.Speech;
import handover.domain.SpeechParameters;
import handover.domain.TableObject;
import handover.domain.Utterance;
import handover.math.Vector3;
import handover.theory.Agent.Human;
import handover.theory.Agent.Robot;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Equation (14') is the filter of {@code handover.belief} where acts may be misperceived, to 1e-12: answers, surprise and
 * gestures. Nobody answers an older question here, because a {@link JointBelief} does not hold what is open.
 */
class JointFilterAgreementTest {
    private static final double SURPRISE = 0.3;
    private static final int MINDS = 100_000;

    private static HandoverDomain domain(double tau, double missed, double misread) {
        List<TableObject> objects = List.of(object("cup", -0.3), object("can", -0.1), object("box", 0.15), object("jar", 0.3));
        return new HandoverDomain(DomainSpec.of("four", objects).with(s -> {
            s.tau = tau;
            s.perception = new PerceptionParameters(missed, misread, MINDS);
            s.speech = new SpeechParameters(0.2, 0.05, 0, SURPRISE, 0.1, List.of(1.0));
            ActParameters wait = s.acts.get("wait");
            s.acts.put("wait", new ActParameters(wait.reward(), wait.duration(), wait.speechRate(), wait.gestureRate(), 0, 0));
        }));
    }

    private static TableObject object(String name, double x) {
        return new TableObject(name, new Vector3(x, 0.6, 0), Map.of(name, 1.0, "thing", 2.0), null);
    }

    @ParameterizedTest
    @CsvSource({"1, 0.1, 0.1", "0.9, 0.2, 0.3", "1, 0.4, 0", "0.95, 0, 0.5"})
    void equalsTheFilter(double tau, double missed, double misread) {
        HandoverDomain domain = domain(tau, missed, misread);
        SplittableRandom random = new SplittableRandom(9);
        List<ActModel> acts = domain.start().acts().stream().filter(a -> !a.isPick()).toList();
        HandoverBelief filter = HandoverBelief.initial(domain);
        Categorical<Human> b = Categorical.uniform(4);
        Categorical<Robot> beta = Categorical.uniform(4);
        JointBelief<Robot, Human> joint = JointBelief.of(b, beta, MINDS);
        Transition<Robot> own = Transition.stay(4, domain.spec().tauHuman());
        Transition<Human> wanted = Transition.stay(4, tau);
        for (int t = 0; t < 5; t++) {
            ActModel act = acts.get(random.nextInt(acts.size()));
            Answer answer = act.isCommunicative() ? Answer.values()[random.nextInt(3)] : Answer.NONE;
            Gesture gesture = HumanModel.sampleGesture(domain.start(), random.nextInt(4), random);
            filter = filter.after(act.act()).saw(gesture);
            filter = answer == Answer.NONE ? filter.closed()
                    : filter.heard(Speech.of(new Utterance(answer, List.of(), List.of(), List.of()))).closed();
            List<Percept> percepts = domain.start().percepts(act);
            double[][] answers = percepts.stream().map(p -> answers(domain, p.act(), answer)).toArray(double[][]::new);
            joint = joint.predicted(own, wanted).perceived(perception(percepts), answers).given(silence(act.type()))
                    .given(new Message<>(HumanModel.gestureDensities(domain.start(), gesture)));
            assertArrayEquals(joint.belief().probabilities(), filter.probabilities(), 1e-12, "b after " + act);
            assertArrayEquals(joint.nested().mean(), filter.human(), 1e-12, "E[beta] after " + act);
        }
    }

    private static double[] answers(HandoverDomain domain, ActModel perceived, Answer answer) {
        boolean asked = perceived.match() != null;
        return IntStream.range(0, 4).mapToDouble(i -> !asked ? answer == Answer.NONE ? 1 : 0
                : domain.answerProbability(answer, perceived.type(), perceived.match()[i])).toArray();
    }

    private static Perception<Robot> perception(List<Percept> percepts) {
        List<Message<Robot>> messages = new ArrayList<>();
        percepts.forEach(p -> messages.add(p.act().act().equals(Act.WAIT) ? Message.nothing(4) : new Message<>(p.act().lambda())));
        return new Perception<>(percepts.stream().mapToDouble(Percept::probability).toArray(), messages);
    }

    /** 1 - phi - kappa (1 - beta_i) for each i that may be wanted: nobody said what they want. */
    private static List<Evidence<Robot>> silence(ActType type) {
        List<Evidence<Robot>> all = new ArrayList<>();
        for (int i = 0; i < 4; i++) {
            double[] w = new double[4];
            Arrays.fill(w, 1 - type.parameters().speechRate() - SURPRISE);
            w[i] += SURPRISE;
            all.add(new Evidence<>(w));
        }
        return all;
    }
}
