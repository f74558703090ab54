package handover.belief;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import burlap.mdp.singleagent.pomdp.beliefstate.EnumerableBeliefState.StateBelief;
import handover.domain.Act;
import handover.domain.ActParameters;
import handover.domain.AnyDomain;
import handover.domain.DomainSpec;
import handover.domain.HandoverDomain;
import handover.domain.HandoverState;
import handover.domain.Observation;
import handover.domain.PickSignal;
import handover.domain.Speech;
import handover.domain.TableObject;
import handover.math.Vector3;
import java.util.List;
import java.util.Map;
import java.util.Random;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;

/** A belief is a value, and a BURLAP belief over the states that share what is known. */
class BeliefEqualityTest {
    private static final List<TableObject> OBJECTS = List.of(
            new TableObject("a", new Vector3(-0.3, 0.6, 0), Map.of("red", 1.0), null),
            new TableObject("b", new Vector3(0.3, 0.6, 0), Map.of("blue", 1.0), null));

    @Property(tries = 100, seed = "63", edgeCases = EdgeCasesMode.NONE)
    void equalHistoriesGiveEqualBeliefs(@ForAll("specs") DomainSpec spec, @ForAll Random random) {
        HandoverDomain one = new HandoverDomain(spec);
        HandoverDomain two = new HandoverDomain(spec.with(s -> {}));
        HandoverBelief a = HandoverBelief.initial(one);
        HandoverBelief b = HandoverBelief.initial(two);
        for (int t = 0; t < 5 && !a.task().done(); t++) {
            Act act = AnyDomain.oneOf(a.task().legalActs(), random).act();
            String words = String.join(" ", AnyDomain.words(one, 2, random));
            PickSignal signal = act.verb().equals("PICK") ? PickSignal.REJECTED : PickSignal.NONE;
            a = a.after(act).given(new Observation(Speech.of(words, one.vocabulary()), null, signal));
            b = new HandoverBeliefUpdate().update(b, new Observation(Speech.of(words, two.vocabulary()), null, signal), act);
            assertEquals(a, b, () -> "after " + act);
            assertEquals(a.hashCode(), b.hashCode(), () -> "hash after " + act);
        }
        assertSame(a, a.copy());
        assertSame(a, a.s());
    }

    @Property(tries = 100, seed = "64", edgeCases = EdgeCasesMode.NONE)
    void aBeliefIsOverStates(@ForAll("specs") DomainSpec spec, @ForAll Random random) {
        HandoverDomain domain = new HandoverDomain(spec);
        double[] prior = AnyDomain.simplex(domain.start().size(), random);
        HandoverBelief b = HandoverBelief.of(domain.task(domain.start()), prior, prior);
        double sum = 0;
        for (StateBelief s : b.nonZeroBeliefs()) {
            int wanted = ((HandoverState) s.s).wanted();
            assertEquals(prior[wanted], s.belief, 1e-12, "belief in object " + wanted);
            assertEquals(s.belief, b.belief(s.s), 0, "by state");
            sum += s.belief;
        }
        assertEquals(1, sum, 1e-12, "sum");
        HandoverState elsewhere = new HandoverState(0, b.task(), new double[prior.length]);
        assertEquals(0, b.belief(elsewhere), 0, "another h cannot be");
        assertArrayEquals(prior, (double[]) b.get("belief"), 1e-12);
        assertArrayEquals(prior, (double[]) b.get("humanBelief"), 0);
        assertEquals(b.task(), b.get("task"));
        assertThrows(IllegalArgumentException.class, () -> b.get("mood"));
    }

    @Test
    void beliefsThatMoveDifferentlyAreNotEqual() {
        // Nobody answers a question at once, but perhaps while the robot waits. The question itself tells nobody anything.
        HandoverDomain domain = new HandoverDomain(DomainSpec.of("x", OBJECTS).with(s -> {
            s.tauHuman = 1;
            s.acts.put("ask", new ActParameters(-1, 1, 0.5, 0.3, 0, 0));
        }));
        HandoverBelief asked = HandoverBelief.initial(domain).after(Act.of("ASK", "a"));
        HandoverBelief waited = asked.after(Act.WAIT);
        Speech no = Speech.of("no", domain.vocabulary());
        double[] one = asked.heard(no).probabilities();
        double[] two = waited.heard(no).probabilities();
        assertNotEquals(one[0], two[0], 0.4, "the answer counts while waiting only");
        assertNotEquals(asked, waited, "equal beliefs, but an answer moves one of them only");
    }

    @Test
    void whatWasSensedInTheStepIsPartOfTheBelief() {
        HandoverDomain domain = new HandoverDomain(DomainSpec.of("x", OBJECTS));
        HandoverBelief start = HandoverBelief.initial(domain);
        assertNotEquals(start, start.closed(), "a closed step hears nothing more");
        assertNotEquals(start, start.revealed(0));
    }

    @Test
    void anEmptyTableHasOneState() {
        HandoverDomain domain = new HandoverDomain(DomainSpec.of("x", OBJECTS.subList(0, 1)));
        HandoverBelief end = HandoverBelief.initial(domain).after(Act.of("PICK", "a")).picked(true);
        assertEquals(1, end.nonZeroBeliefs().size());
        assertEquals(1, end.belief(end.nonZeroBeliefs().get(0).s), 0);
        assertEquals(true, end.task().done());
        assertEquals(end, end.closed(), "nothing to close");
    }

    @Provide
    Arbitrary<DomainSpec> specs() {
        return AnyDomain.specs();
    }
}
