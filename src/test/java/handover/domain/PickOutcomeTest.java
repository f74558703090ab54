package handover.domain;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import burlap.mdp.singleagent.model.TransitionProb;
import handover.math.MatchScore;
import handover.math.Vector3;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;

/** MODEL 5 and 6 by hand: what a pick does under every policy, several handovers in a row, the empty table. */
class PickOutcomeTest {
    private static final List<TableObject> OBJECTS = List.of(object("a", -0.3), object("b", 0), object("c", 0.3));

    private static TableObject object(String name, double x) {
        return new TableObject(name, new Vector3(x, 0.6, 0), Map.of("red", 1.0), null);
    }

    private static HandoverDomain domain(Consumer<DomainSpec.Fields> change) {
        return new HandoverDomain(DomainSpec.of("x", OBJECTS).with(s -> {
            s.rewards = new Rewards(50, -150, -2, 1, MatchScore.NONE, 0.95);
            change.accept(s);
        }));
    }

    private static List<TransitionProb> pick(HandoverDomain domain, HandoverState s, String x) {
        return new HandoverModel(domain, new Random(1)).transitions(s, Act.of("PICK", x));
    }

    private static HandoverState onlyNext(HandoverDomain domain, HandoverState s, String x, double reward) {
        List<TransitionProb> all = pick(domain, s, x);
        assertEquals(1, all.size(), () -> "outcomes of PICK(" + x + ")");
        assertEquals(reward, all.get(0).eo.r, 1e-12, "reward");
        return (HandoverState) all.get(0).eo.op;
    }

    @Test
    void rightAndLast() {
        HandoverDomain domain = domain(s -> {});
        List<TransitionProb> all = pick(domain, domain.initialState("b"), "b");
        assertEquals(2, all.size(), "a next wish for either object that is left");
        for (TransitionProb t : all) {
            HandoverState next = (HandoverState) t.eo.op;
            assertEquals(0.5, t.p, 1e-12);
            assertEquals(49, t.eo.r, 1e-12, "+50 - 1");
            assertEquals("[a, c]", next.task().scene().objects().stream().map(TableObject::name).toList().toString());
            assertEquals(PickSignal.ACCEPTED, next.task().signal());
            assertEquals(true, next.task().done());
        }
    }

    @Test
    void wrongAndReturned() {
        HandoverDomain domain = domain(s -> s.wrongPick = WrongPick.RETURNED);
        HandoverState next = onlyNext(domain, domain.initialState("c"), "b", -151);
        assertEquals(3, next.task().scene().size(), "it goes back");
        assertEquals("c", name(next), "the wish stays");
        assertArrayEquals(new double[] {1 / 3.0, 1 / 3.0, 1 / 3.0}, next.human(), 1e-12, "h restarts");
        assertEquals(PickSignal.REJECTED, next.task().signal());
        assertEquals(false, next.task().done());
        assertEquals(0, next.task().handovers());
    }

    @Test
    void wrongAndRemoved() {
        HandoverDomain domain = domain(s -> s.wrongPick = WrongPick.REMOVED);
        HandoverState next = onlyNext(domain, domain.initialState("c"), "b", -151);
        assertEquals("[a, c]", next.task().scene().objects().stream().map(TableObject::name).toList().toString());
        assertEquals("c", name(next), "the wish stays although its number changed");
        HandoverState other = onlyNext(domain, domain.initialState("a"), "b", -151);
        assertEquals("a", name(other), "and where it did not change");
        HandoverState last = onlyNext(domain, next, "a", -151);
        assertEquals(1, last.task().scene().size());
        HandoverState empty = onlyNext(domain, last, "c", 49);
        assertEquals(0, empty.task().scene().size());
        assertEquals(-1, empty.wanted(), "nothing is left to want");
        assertEquals(true, empty.task().done());
    }

    @Test
    void wrongAndTerminal() {
        HandoverDomain domain = domain(s -> s.wrongPick = WrongPick.TERMINAL);
        HandoverState next = onlyNext(domain, domain.initialState("c"), "b", -151);
        assertEquals(true, next.task().done());
        assertEquals(0, next.task().handovers());
    }

    @Test
    void everythingIsHandedOver() {
        HandoverDomain domain = domain(s -> s.handovers = 5);
        HandoverState s = domain.initialState("b");
        for (int left = 3; left > 0; left--) {
            assertEquals(false, s.task().done(), "before the pick with " + left + " on the table");
            List<TransitionProb> all = pick(domain, s, name(s));
            assertEquals(Math.max(1, left - 1), all.size(), "next wishes");
            s = (HandoverState) all.get(all.size() - 1).eo.op;
            assertEquals(4 - left, s.task().handovers(), "handovers");
        }
        assertEquals(true, s.task().done(), "an empty table ends the episode before 5 handovers");
    }

    @Test
    void handoversAreCountedToTheLast() {
        HandoverDomain domain = domain(s -> s.handovers = 2);
        HandoverState s = (HandoverState) pick(domain, domain.initialState("a"), "a").get(0).eo.op;
        assertEquals(false, s.task().done());
        assertArrayEquals(new double[] {0.5, 0.5}, s.human(), 1e-12, "h restarts over what is left");
        assertEquals(true, ((HandoverState) pick(domain, s, name(s)).get(0).eo.op).task().done());
    }

    @Test
    void theMatchIsPaidBeforeThePickRestartsAnything() {
        HandoverDomain domain = domain(s -> s.rewards = new Rewards(50, -150, -2, 2, MatchScore.LINEAR, 0.95));
        // h' = lambda for a uniform h: .99 for what is picked, .005 for each other.
        onlyNext(domain, domain.initialState("c"), "b", -151 + 2 * 0.005);
        assertEquals(49 + 2 * 0.99, pick(domain, domain.initialState("b"), "b").get(0).eo.r, 1e-12);
    }

    @Test
    void askingAgainAnnoys() {
        HandoverDomain domain = domain(s -> {});
        Task asked = domain.task(domain.start()).effect(Act.of("ASK", "a")).during();
        assertEquals(-2.5, domain.task(domain.start()).effect(Act.of("ASK", "a")).reward(), 1e-12);
        assertEquals(-4.5, asked.effect(Act.of("ASK", "a")).reward(), 1e-12, "open");
        assertEquals(-4.5, asked.effect(Act.WAIT).during().effect(Act.of("ASK", "a")).reward(), 1e-12, "open after a WAIT");
        assertEquals(-2.5, asked.effect(Act.of("ASK", "b")).reward(), 1e-12, "another question");
        assertEquals(-1.8, asked.effect(Act.of("POINT", "a")).reward(), 1e-12, "another act about the same");
        assertEquals(-2.5, asked.answered(Answer.NO).effect(Act.of("ASK", "a")).reward(), 1e-12, "answered");
        assertEquals(-1, asked.effect(Act.WAIT).reward(), 1e-12, "waiting is no repetition");
    }

    private static String name(HandoverState s) {
        return s.task().scene().objects().get(s.wanted()).name();
    }
}
