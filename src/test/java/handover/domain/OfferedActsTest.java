package handover.domain;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.math.Vector3;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;

/** MODEL 3: which acts there are. */
class OfferedActsTest {
    /** red: {a, b} 4 times; warm: {a, b} 5 times; thing: all; tied: {b, c} once each, as are bound and cup. */
    private static final List<TableObject> OBJECTS = List.of(
            object("a", Map.of("red", 2.0, "warm", 4.0, "thing", 1.0)),
            object("b", Map.of("red", 2.0, "warm", 1.0, "thing", 1.0, "tied", 1.0, "bound", 1.0)),
            object("c", Map.of("thing", 1.0, "tied", 1.0, "bound", 1.0, "cup", 0.0)));

    private static TableObject object(String name, Map<String, Double> words) {
        return new TableObject(name, new Vector3(name.charAt(0) - 'b', 1, 0), words, null);
    }

    private static HandoverDomain domain(AskSets sets) {
        return new HandoverDomain(DomainSpec.of("x", OBJECTS).with(s -> s.ask = new AskParameters(sets)));
    }

    private static List<Act> offered(Scene scene) {
        return scene.acts().stream().map(ActModel::act).toList();
    }

    @Test
    void singletonsOnly() {
        List<Act> expected = new ArrayList<>(List.of(Act.WAIT));
        for (String verb : List.of("PICK", "ASK", "POINT", "LOOK")) {
            List.of("a", "b", "c").forEach(x -> expected.add(Act.of(verb, x)));
        }
        assertEquals(expected, offered(domain(AskSets.SINGLETONS).start()));
    }

    @Test
    void aWordOfSomeButNotAllIsAskedOnceUnderItsMostCommonWord() {
        Scene scene = domain(AskSets.ATTRIBUTES).start();
        List<Act> sets = offered(scene).stream().filter(a -> a.objects().size() > 1).toList();
        assertEquals(Set.of(Act.of("ASK", "a", "b"), Act.of("ASK", "b", "c")), new HashSet<>(sets));
        assertEquals(2, sets.size(), "each set once");
        assertEquals("warm", scene.model(Act.of("ASK", "a", "b")).say(), "5 counts beat 4");
        assertEquals("bound", scene.model(Act.of("ASK", "b", "c")).say(), "of 2 and 2 counts the first in the alphabet");
    }

    @Test
    void setsFollowTheTable() {
        Scene two = domain(AskSets.ATTRIBUTES).start().without(2);
        assertEquals(List.of(), offered(two).stream().filter(a -> a.objects().size() > 1).toList(),
                "what both of two objects have does not tell them apart");
        assertEquals(List.of(), domain(AskSets.ATTRIBUTES).start().without(0).without(0).without(0).acts());
    }

    @Test
    void aLabelIsSaidAsItIsWritten() {
        TableObject mug = new TableObject("big_mug", new Vector3(0, 1, 0), Map.of("mug", 1.0), null);
        TableObject cup = new TableObject("x1", new Vector3(1, 1, 0), Map.of("cup", 1.0), "the Red cup");
        Scene scene = new HandoverDomain(DomainSpec.of("x", List.of(mug, cup))).start();
        assertEquals("big mug", scene.model(Act.of("ASK", "big_mug")).say());
        assertEquals("the Red cup", scene.model(Act.of("ASK", "x1")).say());
    }

    @Property(tries = 150, seed = "31", edgeCases = EdgeCasesMode.NONE)
    void theActsAreThoseOfTheText(@ForAll("specs") DomainSpec spec) {
        Scene scene = new HandoverDomain(spec).start();
        Map<List<String>, List<String>> questions = new ModelOracle(spec, spec.objects()).questions();
        Set<Act> expected = new HashSet<>(Set.of(Act.WAIT));
        questions.keySet().forEach(set -> expected.add(new Act("ASK", set)));
        for (TableObject o : spec.objects()) {
            List.of("PICK", "POINT", "LOOK").forEach(verb -> expected.add(Act.of(verb, o.name())));
        }
        assertEquals(expected, new HashSet<>(offered(scene)));
        assertEquals(expected.size(), scene.acts().size(), "an act is offered twice: " + scene.acts());
        questions.forEach((set, words) -> assertTrue(set.size() == 1
                || scene.model(new Act("ASK", set)).say().equals(words.get(0)),
                () -> set + ": said " + scene.model(new Act("ASK", set)).say() + ", expected " + words));
    }

    @Provide
    Arbitrary<DomainSpec> specs() {
        return AnyDomain.specs();
    }
}
