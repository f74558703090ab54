package handover.domain;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import handover.math.Vector3;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.Stream;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;

/** MODEL 4.1: p(word | object), plain, in contrast to an open reference, and negated. */
class WordProbabilityTest {
    private static final double CLOSE = 1e-9;
    /** V = {blue, box, cup, red}. */
    private static final List<TableObject> OBJECTS = List.of(
            new TableObject("a", new Vector3(-0.3, 0.6, 0), Map.of("red", 3.0, "cup", 1.0), null),
            new TableObject("b", new Vector3(0, 0.6, 0), Map.of("red", 1.0, "box", 3.0), null),
            new TableObject("c", new Vector3(0.3, 0.6, 0), Map.of("blue", 4.0), null));

    private static HandoverDomain domain(double alpha, double eta) {
        return new HandoverDomain(DomainSpec.of("x", OBJECTS).with(s ->
                s.speech = new SpeechParameters(alpha, 0.05, eta, 0, 0.01, List.of(1.0))));
    }

    private static double p(HandoverDomain domain, String word, int i, ActModel reference) {
        return domain.start().words(reference).probabilities(domain.vocabulary().indexOf(word))[i];
    }

    @Test
    void smoothingByHand() {
        assertEquals(0.75, p(domain(0, 0), "red", 0, null), CLOSE);
        assertEquals(0, p(domain(0, 0), "blue", 0, null), 0, "alpha = 0 is the report's formula");
        assertEquals(3.2 / 4.8, p(domain(0.2, 0), "red", 0, null), CLOSE);
        assertEquals(0.2 / 4.8, p(domain(0.2, 0), "blue", 0, null), CLOSE);
        assertEquals(4.0 / 8, p(domain(1, 0), "red", 0, null), CLOSE);
        assertEquals(1.0 / 8, p(domain(1, 0), "blue", 0, null), CLOSE);
    }

    @Test
    void contrastByHand() {
        HandoverDomain domain = domain(0, 0.5);
        ActModel askA = domain.start().model(Act.of("ASK", "a"));
        // b: red .25 halved, box .75 kept, divided by .875; a itself is not in contrast to a; c shares no word.
        assertEquals(0.125 / 0.875, p(domain, "red", 1, askA), CLOSE);
        assertEquals(0.75 / 0.875, p(domain, "box", 1, askA), CLOSE);
        assertEquals(0.75, p(domain, "red", 0, askA), CLOSE, "the object itself");
        assertEquals(1, p(domain, "blue", 2, askA), CLOSE, "shares no word");
        assertEquals(0.25, p(domain, "red", 1, null), CLOSE, "nothing is open");
        HandoverDomain full = domain(0, 1);
        assertEquals(0, p(full, "red", 1, full.start().model(Act.of("ASK", "a"))), 0);
        assertEquals(1, p(full, "box", 1, full.start().model(Act.of("LOOK", "a"))), CLOSE, "a look is a reference too");
    }

    @Test
    void theVocabularyIsThatOfTheStart() {
        Scene later = domain(1, 0).start().without(2);
        assertEquals(4, later.domain().vocabulary().size());
        assertEquals(1.0 / 8, later.words(null).probabilities(later.domain().vocabulary().indexOf("blue"))[0], CLOSE);
    }

    @Property(tries = 150, seed = "43", edgeCases = EdgeCasesMode.NONE)
    void tablesAreThoseOfTheText(@ForAll("specs") DomainSpec spec) {
        HandoverDomain domain = new HandoverDomain(spec);
        ModelOracle oracle = new ModelOracle(spec, spec.objects());
        List<Act> references = Stream.concat(Stream.of(Act.WAIT), domain.start().acts().stream()
                .filter(ActModel::isCommunicative).map(ActModel::act)).toList();
        for (Act reference : references) {
            Act open = reference.equals(Act.WAIT) ? null : reference;
            Words words = domain.start().words(open == null ? null : domain.start().model(open));
            for (int i = 0; i < oracle.n(); i++) {
                double sum = 0;
                for (String w : domain.vocabulary().words()) {
                    int object = i;
                    double p = words.probabilities(domain.vocabulary().indexOf(w))[i];
                    sum += p;
                    assertEquals(oracle.word(w, i, open), p, CLOSE,
                            () -> "p(" + w + " given object " + object + ", " + open + " open)");
                }
                assertEquals(1, sum, CLOSE, "sum over V");
            }
        }
    }

    @Property(tries = 200, seed = "44", edgeCases = EdgeCasesMode.NONE)
    void anUtteranceIsAProduct(@ForAll("specs") DomainSpec spec, @ForAll Random random) {
        HandoverDomain domain = new HandoverDomain(spec);
        ModelOracle oracle = new ModelOracle(spec, spec.objects());
        Utterance said = new Utterance(Answer.NONE, AnyDomain.someWords(domain, 4, random),
                AnyDomain.someWords(domain, 3, random), List.of("zork"));
        ActModel act = AnyDomain.oneOf(domain.start().acts(), random);
        ActModel reference = act.isCommunicative() ? act : null;
        double[] log = new double[oracle.n()];
        boolean possible = HumanModel.addLogWords(domain.start(), reference, said, log);
        boolean any = false;
        for (int i = 0; i < log.length; i++) {
            double p = 1;
            for (String w : said.content()) {
                p *= oracle.word(w, i, reference == null ? null : act.act());
            }
            for (String w : said.negated()) {
                p *= oracle.negated(w, i);
            }
            any |= p > 0;
            int object = i;
            assertEquals(p, Math.exp(log[i]), CLOSE, () -> said + " given object " + object + " after " + act);
        }
        assertEquals(any, possible, "whether anything can have been meant");
    }

    @Test
    void aNegatedWordCountsAgainstWhatHasIt() {
        double[] log = new double[3];
        HumanModel.addLogWords(domain(0.2, 0).start(), null,
                new Utterance(Answer.NONE, List.of(), List.of("red", "red", "cup"), List.of()), log);
        assertEquals(3 * Math.log(0.05), log[0], CLOSE, "two red, one cup");
        assertEquals(2 * Math.log(0.05), log[1], CLOSE, "two red");
        assertEquals(0, log[2], 0, "neither");
        assertFalse(HumanModel.addLogWords(domain(0, 0).start(), null,
                new Utterance(Answer.NONE, List.of("blue", "red"), List.of(), List.of()), new double[3]),
                "nothing is blue and red");
    }

    @Provide
    Arbitrary<DomainSpec> specs() {
        return AnyDomain.specs();
    }
}
