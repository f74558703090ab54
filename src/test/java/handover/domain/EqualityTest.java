package handover.domain;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import burlap.mdp.core.action.Action;
import handover.belief.HandoverBelief;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;

/** Acts, states, tasks and scenes are values: equal if made alike, also by another instance of the same domain. */
class EqualityTest {
    private static final int WALK = 6;

    @Property(tries = 100, seed = "71", edgeCases = EdgeCasesMode.NONE)
    void equalWalksGiveEqualStates(@ForAll("specs") DomainSpec spec, @ForAll Random random) {
        HandoverDomain first = new HandoverDomain(spec);
        HandoverDomain second = new HandoverDomain(spec.with(s -> {}));
        long seed = random.nextLong();
        HandoverModel one = new HandoverModel(first, new Random(seed));
        HandoverModel two = new HandoverModel(second, new Random(seed));
        HandoverState s = first.initialState("thing_0");
        HandoverState t = second.initialState("thing_0");
        Set<HandoverState> seen = new HashSet<>();
        for (int k = 0; k < WALK && !s.task().done(); k++) {
            Act act = AnyDomain.oneOf(s.task().legalActs(), random).act();
            s = (HandoverState) one.sample(s, act).op;
            t = (HandoverState) two.sample(t, Act.of(act.verb(), act.objects().toArray(String[]::new))).op;
            assertEquals(s, t, () -> "after " + act);
            assertEquals(s.hashCode(), t.hashCode(), () -> "hash after " + act);
            assertEquals(s.task(), t.task(), () -> "task after " + act);
            assertEquals(s.task().scene(), t.task().scene(), () -> "scene after " + act);
            seen.add(s);
            assertEquals(true, seen.contains(t), "found in a set");
        }
    }

    @Property(tries = 100, seed = "72", edgeCases = EdgeCasesMode.NONE)
    void whatDiffersIsNotEqual(@ForAll("several") DomainSpec spec, @ForAll Random random) {
        HandoverDomain domain = new HandoverDomain(spec);
        int n = domain.start().size();
        double[] h = AnyDomain.simplex(n, random);
        Task task = domain.task(domain.start());
        HandoverState s = new HandoverState(0, task, h);
        assertNotEquals(s, new HandoverState(1, task, h), "what is wanted");
        assertNotEquals(s, new HandoverState(0, task.effect(Act.of("ASK", "thing_0")).during(), h), "what is open");
        double[] other = h.clone();
        other[0] += 1e-9;
        assertNotEquals(s, new HandoverState(0, task, other), "h");
        assertNotEquals(domain.start(), domain.start().without(0), "the table");
        assertNotEquals(Act.of("POINT", "thing_0"), Act.of("LOOK", "thing_0"), "verbs");
        assertNotEquals(Act.of("PICK", "thing_0"), Act.of("PICK", "thing_1"), "objects");
    }

    @Property(tries = 100, seed = "73", edgeCases = EdgeCasesMode.NONE)
    void whatIsLegalDependsOnWhatIsKnown(@ForAll("specs") DomainSpec spec, @ForAll Random random) {
        HandoverDomain domain = new HandoverDomain(spec);
        HandoverBelief belief = HandoverBelief.initial(domain);
        for (ActType type : domain.types()) {
            List<Action> legal = type.allApplicableActions(belief);
            for (int i = 0; i < domain.start().size(); i++) {
                HandoverState s = new HandoverState(i, belief.task(), AnyDomain.simplex(domain.start().size(), random));
                assertEquals(legal, type.allApplicableActions(s), type.verb() + " where object " + i + " is wanted");
            }
        }
        assertEquals(domain.start().acts().size(), domain.types().stream()
                .mapToInt(type -> type.allApplicableActions(belief).size()).sum(), "the types share out all acts");
    }

    @Property(tries = 100, seed = "74", edgeCases = EdgeCasesMode.NONE)
    void actTypesReadTheirActs(@ForAll("specs") DomainSpec spec) {
        HandoverDomain domain = new HandoverDomain(spec);
        for (ActModel model : domain.start().acts()) {
            Act act = model.act();
            assertEquals(act, model.type().associatedAction(String.join(",", act.objects())), "without spaces");
            assertEquals(act, model.type().associatedAction(" " + String.join(" , ", act.objects())), "with spaces");
            assertEquals(act.verb(), act.actionName());
            assertEquals(act.verb(), model.type().typeName());
            assertSame(model, domain.start().model(act), "found by an equal act");
            assertEquals(act, act.copy());
        }
        assertEquals(Act.WAIT, domain.types().get(0).associatedAction(null), "no objects");
    }

    @Provide
    Arbitrary<DomainSpec> specs() {
        return AnyDomain.specs();
    }

    @Provide
    Arbitrary<DomainSpec> several() {
        return AnyDomain.specs().filter(s -> s.objects().size() > 1);
    }
}
