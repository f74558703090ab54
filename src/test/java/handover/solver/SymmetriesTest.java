package handover.solver;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.AskParameters;
import handover.domain.AskSets;
import handover.domain.DomainSpec;
import handover.domain.Gesture;
import handover.domain.HandoverDomain;
import handover.domain.Observation;
import handover.domain.PickSignal;
import handover.domain.Scene;
import handover.domain.Speech;
import handover.domain.TableObject;
import handover.domain.WrongPick;
import handover.io.DomainFiles;
import handover.math.Vector3;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Only what really makes no difference is a symmetry. */
class SymmetriesTest {

    @ParameterizedTest
    @ValueSource(strings = {"bowls-and-spoons", "bowls-incremental", "bowls-communicated", "table-line-5", "table-line-6", "kitchen-20"})
    void positionsAndWordsTellShippedObjectsApart(String name) {
        assertEquals(1, Symmetries.of(DomainFiles.load(name).start()).size());
    }

    @Test
    void cupsCanBeSwapped() {
        List<Symmetry> found = Symmetries.of(Mirrored.domain().start());
        assertEquals(2, found.size());
        assertArrayEquals(new int[] {0, 1, 2}, found.get(0).objects());
        assertArrayEquals(new int[] {2, 1, 0}, found.get(1).objects());
    }

    /** Whatever happens, the mirrored thing leads to the mirrored belief. */
    @Test
    void theFilterAgrees() {
        HandoverDomain domain = Mirrored.domain();
        HandoverBelief one = HandoverBelief.initial(domain);
        HandoverBelief other = one;
        one = happens(one, "POINT", "left_cup", "red cup", new Vector3(-0.2, -0.8, -0.3));
        other = happens(other, "POINT", "right_cup", "blue cup", new Vector3(0.2, -0.8, -0.3));
        one = happens(one, "ASK", "left_cup", "no not red", new Vector3(0.1, -0.7, -0.2));
        other = happens(other, "ASK", "right_cup", "no not blue", new Vector3(-0.1, -0.7, -0.2));
        double[] b = one.probabilities();
        double[] h = one.human();
        assertArrayEquals(new double[] {b[2], b[1], b[0]}, other.probabilities(), 1e-12);
        assertArrayEquals(new double[] {h[2], h[1], h[0]}, other.human(), 1e-12);
    }

    private static HandoverBelief happens(HandoverBelief b, String verb, String object, String said, Vector3 pointing) {
        return b.after(Act.of(verb, object)).given(new Observation(Speech.of(said, b.domain().vocabulary()),
                new Gesture(b.domain().spec().shoulder(), pointing), PickSignal.NONE));
    }

    /** Moving one cup, its words, its word for nothing else, or the person, ends it. */
    @Test
    void smallDifferencesCount() {
        assertEquals(1, of(s -> s.with(f -> f.shoulder = new Vector3(0.01, 1.4, 0.35))));
        assertEquals(1, of(s -> s.with(f -> f.pointingOrigin = new Vector3(0.01, 0, 0.3))));
        assertEquals(1, of(s -> replaced(s, new TableObject("left_cup", new Vector3(-0.21, 0.6, 0), s.objects().get(0).words(), "red cup"))));
        assertEquals(1, of(s -> replaced(s, new TableObject("left_cup", new Vector3(-0.2, 0.6, 0), Map.of("red", 2.1, "cup", 3.0), "red cup"))));
        assertEquals(1, of(s -> replaced(s, new TableObject("left_cup", new Vector3(-0.2, 0.6, 0), s.objects().get(0).words(), "cup"))));
        assertEquals(2, of(s -> s.with(f -> f.tau = 0.9)));
    }

    /** A user's seams may treat objects by name; questions about sets change with what is left. */
    @Test
    void whereItCannotBeKnownThereIsNone() {
        HandoverDomain own = new HandoverDomain(Mirrored.spec()) { };
        assertEquals(1, Symmetries.of(own.start()).size());
        assertEquals(2, of(s -> s.with(f -> f.wrongPick = WrongPick.REMOVED)));
        assertEquals(2, of(s -> s.with(f -> f.ask = new AskParameters(AskSets.ATTRIBUTES))));
        assertEquals(1, of(s -> s.with(f -> {
            f.wrongPick = WrongPick.REMOVED;
            f.ask = new AskParameters(AskSets.ATTRIBUTES);
        })));
    }

    /** Many things that nothing tells apart: a part of the many symmetries is enough. */
    @Test
    void aRingHasAsManyAsAreLookedFor() {
        List<TableObject> same = new ArrayList<>();
        for (int i = 0; i < 8; i++) {
            same.add(new TableObject("cup" + i, new Vector3(0, 0.6, 0), Map.of("cup", 1.0), "cup"));
        }
        Scene scene = new HandoverDomain(DomainSpec.of("pile", same)).start();
        assertEquals(Symmetries.MOST, Symmetries.of(scene).size());
    }

    private static int of(UnaryOperator<DomainSpec> change) {
        return Symmetries.of(new HandoverDomain(change.apply(Mirrored.spec())).start()).size();
    }

    private static DomainSpec replaced(DomainSpec s, TableObject left) {
        return s.with(f -> f.objects = List.of(left, s.objects().get(1), s.objects().get(2)));
    }
}
