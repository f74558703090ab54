package handover.domain;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import burlap.mdp.core.oo.state.OOVariableKey;
import burlap.mdp.core.oo.state.ObjectInstance;
import handover.math.Vector3;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** A state seen by BURLAP: object instances with attributes. */
class OoStateTest {
    private static final List<TableObject> OBJECTS = List.of(
            new TableObject("cup", new Vector3(-0.3, 0.6, 0.1), Map.of("red", 3.0), null),
            new TableObject("box", new Vector3(0.3, 0.5, 0), Map.of("blue", 3.0), null));
    private static final HandoverDomain DOMAIN = new HandoverDomain(DomainSpec.of("x", OBJECTS));
    private static final HandoverState STATE = new HandoverState(1,
            DOMAIN.task(DOMAIN.start()).effect(Act.of("ASK", "cup")).during().answered(Answer.NO),
            new double[] {0.25, 0.75});

    @Test
    void oneInstanceForEachThingAndOneForTheTask() {
        assertEquals(3, STATE.numObjects());
        assertEquals(List.of("cup", "box", "task"), STATE.objects().stream().map(ObjectInstance::name).toList());
        assertEquals(List.of("cup", "box"), STATE.objectsOfClass(HandoverState.CLASS_OBJECT).stream()
                .map(ObjectInstance::name).toList());
        assertEquals(1, STATE.objectsOfClass(HandoverState.CLASS_TASK).size());
        assertEquals(List.of(), STATE.objectsOfClass("table"));
        assertNull(STATE.object("spoon"));
    }

    @Test
    void attributes() {
        ObjectInstance cup = STATE.object("cup");
        assertEquals(HandoverState.CLASS_OBJECT, cup.className());
        assertEquals(Map.of("x", -0.3, "y", 0.6, "z", 0.1, "humanBelief", 0.25), all(cup));
        assertEquals(Map.of("wanted", "box", "reference", "ASK(cup)", "answer", Answer.NO, "target", "", "progress", 0,
                "signal", PickSignal.NONE, "handovers", 0, "done", false), all(STATE.object("task")));
    }

    private static Map<Object, Object> all(ObjectInstance o) {
        Map<Object, Object> values = new java.util.HashMap<>();
        o.variableKeys().forEach(k -> values.put(k, o.get(k)));
        return values;
    }

    @Test
    void flatKeysReachEverything() {
        assertEquals(2 * 4 + 8, STATE.variableKeys().size());
        assertEquals(16, new HashSet<>(STATE.variableKeys()).size(), "each key once");
        for (Object key : STATE.variableKeys()) {
            OOVariableKey k = (OOVariableKey) key;
            assertEquals(STATE.object(k.obName).get(k.obVarKey), STATE.get(key), () -> "value of " + key);
        }
        assertEquals(0.75, STATE.get(new OOVariableKey("box", "humanBelief")));
        assertEquals("box", STATE.get("task:wanted"));
    }

    @Test
    void copies() {
        assertEquals(STATE, STATE.copy());
        assertEquals(STATE.hashCode(), STATE.copy().hashCode());
        assertSame(STATE, STATE.s());
        ObjectInstance renamed = STATE.object("cup").copyWithName("mug");
        assertEquals("mug", renamed.name());
        assertEquals(all(STATE.object("cup")), all(renamed));
        assertEquals(STATE.object("cup"), STATE.object("cup").copy());
        assertEquals(false, STATE.toString().isBlank());
    }

    @Test
    void anEmptyTable() {
        HandoverState empty = new HandoverState(-1, DOMAIN.task(DOMAIN.start().without(0).without(0)), new double[0]);
        assertEquals(1, empty.numObjects());
        assertEquals("", empty.object("task").get("wanted"));
    }

    @Test
    void observationsAreStates() {
        Observation o = new Observation(Speech.of("red", DOMAIN.vocabulary()), null, PickSignal.NONE);
        assertEquals(List.of("speech", "gesture", "signal"), o.variableKeys());
        assertEquals(o.speech(), o.get("speech"));
        assertNull(o.get("gesture"));
        assertEquals(PickSignal.NONE, o.get("signal"));
        assertThrows(IllegalArgumentException.class, () -> o.get("smell"));
        assertEquals(o, o.copy());
        assertEquals(new Observation(Speech.of("red", DOMAIN.vocabulary()), null, PickSignal.NONE), o);
    }

    /** A thing may have any name, also that of the instance that holds the task; names of instances must differ. */
    @Test
    void aThingCalledTask() {
        HandoverState s;
        try {
            List<TableObject> objects = List.of(new TableObject("task", new Vector3(0, 1, 0), Map.of("red", 1.0), null));
            s = new HandoverDomain(DomainSpec.of("x", objects)).initialState("task");
        } catch (InvalidParameterException refused) {
            return; // that is one way
        }
        assertEquals(s.numObjects(), s.objects().stream().map(ObjectInstance::name).distinct().count(),
                () -> "two instances have one name: " + s.objects().stream().map(ObjectInstance::name).toList());
    }
}
