package handover.domain;

import static org.junit.jupiter.api.Assertions.assertEquals;

import handover.math.Vector3;
import java.util.List;
import java.util.Map;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** MODEL 4.1: who answers what to which act, and who speaks at all. */
class HumanReplyTest {
    private static final double CLOSE = 1e-9;
    private static final List<TableObject> OBJECTS = List.of(
            new TableObject("a", new Vector3(-0.3, 0.6, 0), Map.of("red", 1.0), null),
            new TableObject("b", new Vector3(0.3, 0.6, 0), Map.of("blue", 1.0), null));

    @ParameterizedTest(name = "{0} with M = {1}: yes {2}, no {3}")
    @CsvSource({"ASK, 1, 0.9405, 0.0095", "ASK, 0, 0.0095, 0.9405", "POINT, 1, 0.891, 0.009", "POINT, 0, 0.009, 0.891",
        "LOOK, 1, 0.297, 0.003", "LOOK, 0, 0.003, 0.297", "PICK, 1, 0.099, 0.001", "PICK, 0, 0.007, 0.693",
        "WAIT, 1, 0.495, 0.005", "WAIT, 0, 0.005, 0.495", "PICK, 0.25, 0.03, 0.52"})
    void defaultsByHand(String verb, double match, double yes, double no) {
        HandoverDomain domain = new HandoverDomain(DomainSpec.of("x", OBJECTS));
        ActType type = domain.types().stream().filter(t -> t.verb().equals(verb)).findFirst().orElseThrow();
        assertEquals(yes, domain.answerProbability(Answer.YES, type, match), CLOSE, "yes");
        assertEquals(no, domain.answerProbability(Answer.NO, type, match), CLOSE, "no");
    }

    @Property(tries = 150, seed = "41", edgeCases = EdgeCasesMode.NONE)
    void answersToEveryActAndToWaitingAfterIt(@ForAll("specs") DomainSpec spec) {
        HandoverDomain domain = new HandoverDomain(spec);
        ModelOracle oracle = new ModelOracle(spec, spec.objects());
        Task start = domain.task(domain.start());
        for (ActModel model : domain.start().acts()) {
            Act act = model.act();
            ActEffect effect = start.effect(act);
            boolean pick = act.verb().equals("PICK");
            if (!pick) {
                Act open = act.equals(Act.WAIT) ? null : act;
                compare(oracle, act, open, effect);
                compare(oracle, Act.WAIT, open, effect.during().effect(Act.WAIT));
                compare(oracle, Act.WAIT, null, effect.during().answered(Answer.NO).effect(Act.WAIT));
            }
            for (int i = 0; pick && i < oracle.n(); i++) {
                assertEquals(1, effect.answers(Answer.NONE)[i], 0, "nobody answers a pick that completes");
            }
        }
    }

    private static void compare(ModelOracle oracle, Act act, Act open, ActEffect effect) {
        for (int i = 0; i < oracle.n(); i++) {
            for (Answer answer : Answer.values()) {
                int object = i;
                assertEquals(oracle.answer(answer, act, open, i), effect.answers(answer)[i], CLOSE,
                        () -> "P(" + answer + " to " + act + " with " + open + " open given object " + object + ")");
            }
        }
    }

    @Property(tries = 300, seed = "42")
    void surpriseMakesPeopleSpeak(@ForAll @DoubleRange(min = 0, max = 1) double phi,
            @ForAll @DoubleRange(min = 0, max = 1) double kappa, @ForAll @DoubleRange(min = 0, max = 1) double expected) {
        DomainSpec spec = DomainSpec.of("x", OBJECTS).with(s -> {
            s.acts.put("ask", new ActParameters(-1, 1, phi, 0.3, 0.5, 0.5));
            s.speech = new SpeechParameters(0.2, 0.05, 0, kappa, 0.01, List.of(1.0));
        });
        HandoverDomain domain = new HandoverDomain(spec);
        ActModel ask = domain.start().model(Act.of("ASK", "a"));
        double rate = Math.min(0.99, phi + kappa * (1 - expected));
        assertEquals(rate, domain.contentRate(ask.type(), expected), CLOSE, "the text");
        assertEquals(new ModelOracle(spec, OBJECTS).contentRate(ask.act(), expected),
                domain.contentRate(ask.type(), expected), CLOSE, "the oracle");
    }

    @Test
    void whoHasNoWordsSaysNone() {
        TableObject mute = new TableObject("a", new Vector3(0, 0.6, 0), Map.of(), null);
        HandoverDomain domain = new HandoverDomain(DomainSpec.of("x", List.of(mute)));
        assertEquals(0, domain.contentRate(domain.types().get(0), 0.5), 0);
    }

    @Test
    void aPickTakesTheFloor() {
        // Decided in the package: PICK neither becomes nor keeps an open reference.
        HandoverDomain domain = new HandoverDomain(DomainSpec.of("x", OBJECTS));
        Task asked = domain.task(domain.start()).effect(Act.of("ASK", "a")).during();
        assertEquals(Act.of("ASK", "a"), asked.openReference());
        assertEquals(null, asked.effect(Act.of("PICK", "b")).during().reference());
        assertEquals(Act.of("ASK", "a"), asked.effect(Act.WAIT).during().openReference(), "WAIT keeps a question open");
        assertEquals(Act.of("LOOK", "b"), asked.effect(Act.of("LOOK", "b")).during().openReference(),
                "a communicative act replaces it");
        assertEquals(null, asked.answered(Answer.YES).openReference(), "an answer closes it");
    }

    @Provide
    Arbitrary<DomainSpec> specs() {
        return AnyDomain.specs();
    }
}
