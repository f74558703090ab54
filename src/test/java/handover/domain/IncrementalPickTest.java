package handover.domain;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.belief.HandoverBelief;
import handover.io.DomainFiles;
import org.junit.jupiter.api.Test;

/** MODEL 5, incremental column, by hand. */
class IncrementalPickTest {
    private static final Act PICK = Act.of("PICK", "metal_bowl");
    private static final Act OTHER = Act.of("PICK", "color_bowl");

    private final HandoverDomain domain = DomainFiles.load("bowls-incremental");
    private final Task start = domain.task(domain.start());

    private static Task after(Task task, Act act) {
        return task.effect(act).during();
    }

    @Test
    void completesWhenItWasChosenThreeTimes() {
        Task once = after(start, PICK);
        Task twice = after(once, PICK);
        assertEquals(1, once.progress());
        assertEquals(PickSignal.MOVING, once.signal());
        assertEquals(2, twice.progress());
        assertFalse(once.effect(PICK).completes());
        assertTrue(twice.effect(PICK).completes());
        assertEquals(PickSignal.ACCEPTED, after(twice, PICK).completed(true).signal());
        assertEquals(3, after(twice, PICK).completed(true).scene().size());
    }

    @Test
    void anyOtherActCancels() {
        Task twice = after(after(start, PICK), PICK);
        assertEquals(0, after(twice, Act.WAIT).progress());
        assertNull(after(twice, Act.WAIT).target());
        assertEquals(0, after(twice, Act.of("ASK", "metal_bowl")).progress());
        assertEquals("color_bowl", after(twice, OTHER).target());
        assertEquals(1, after(twice, OTHER).progress());
    }

    /** The first increment from uniform: tau_H keeps uniform, eps_pick = 0.01 for the other three. */
    @Test
    void anIncrementIsAnIndisputableSign() {
        double[] h = HandoverBelief.initial(domain).after(PICK).human();
        assertEquals(0.99, h[0], 1e-12);
        assertEquals(0.01 / 3, h[1], 1e-12);
    }

    /**
     * Silence while the robot reaches for metal_bowl, by hand: no answer 1 - .1 for metal_bowl and 1 - .7 for the others;
     * no words 1 - (.5 + .3 (1 - h')) with h' = .99 and .01/3; gestures tell nothing by staying away.
     */
    @Test
    void silenceIsEvidence() {
        Observation silence = new Observation(null, null, PickSignal.MOVING);
        double[] b = HandoverBelief.initial(domain).after(PICK).given(silence).probabilities();
        double wanted = (1 - 0.1) * (1 - (0.5 + 0.3 * (1 - 0.99)));
        double other = (1 - 0.7) * (1 - (0.5 + 0.3 * (1 - 0.01 / 3)));
        assertEquals(wanted / (wanted + 3 * other), b[0], 1e-12);
        assertTrue(b[0] > 0.6, "b = " + b[0]);
    }

    /** With advance probability 0.5 the model splits each increment, and the robot knows from the signal what happened. */
    @Test
    void anIncrementMayStall() {
        HandoverDomain unsure = DomainFiles.domain(domain.spec().with(s -> s.pick = new PickParameters(2, 0.5)));
        HandoverBelief belief = HandoverBelief.initial(unsure).after(PICK);
        assertEquals(1, belief.given(new Observation(null, null, PickSignal.MOVING)).task().progress());
        assertEquals(0, belief.given(Observation.NOTHING).task().progress());
        assertEquals("metal_bowl", belief.given(Observation.NOTHING).task().target());
        HandoverModel model = new HandoverModel(unsure, null);
        double moves = model.transitions(unsure.initialState("metal_bowl"), PICK).stream()
                .filter(t -> ((HandoverState) t.eo.op).task().progress() == 1).mapToDouble(t -> t.p).sum();
        assertEquals(0.5, moves, 1e-12);
    }
}
