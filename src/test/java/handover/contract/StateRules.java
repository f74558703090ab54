package handover.contract;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertSame;

import burlap.mdp.core.oo.state.OOState;
import burlap.mdp.core.oo.state.ObjectInstance;
import burlap.mdp.core.state.State;
import burlap.mdp.singleagent.model.TransitionProb;
import handover.domain.HandoverDomain;
import handover.io.DomainFiles;
import java.util.List;

/** Rules about states and files. */
final class StateRules {
    private StateRules() {}

    static void values(Walk walk) {
        for (Walk.Visit v : walk.visits()) {
            State s = v.state();
            assertEquals(s, s.copy(), "copy, " + v);
            assertEquals(s.hashCode(), s.copy().hashCode(), "hash of the copy, " + v);
            assertNotEquals(s, null, v.toString());
            List<TransitionProb> once = walk.model.transitions(s, v.act());
            List<TransitionProb> again = walk.model.transitions(s.copy(), v.act());
            for (int k = 0; k < once.size(); k++) {
                assertEquals(once.get(k).eo.op, again.get(k).eo.op, "the same next state, made twice, " + v);
                assertEquals(once.get(k).eo.op.hashCode(), again.get(k).eo.op.hashCode(), "its hash, " + v);
            }
            for (Object key : s.variableKeys()) {
                assertNotNull(s.get(key), "variable " + key + ", " + v);
            }
            OOState objects = (OOState) s;
            assertEquals(objects.numObjects(), objects.objects().size(), "number of objects, " + v);
            for (ObjectInstance o : objects.objects()) {
                assertEquals("other", o.copyWithName("other").name(), v.toString());
                assertEquals(o, objects.object(o.name()), "object " + o.name() + ", " + v);
            }
        }
    }

    static void serialisation(Walk walk) {
        HandoverDomain read = DomainFiles.domain(DomainFiles.fromJson(DomainFiles.toJson(walk.domain.spec()), "copy"));
        assertEquals(walk.domain.spec(), read.spec(), "the spec");
        assertSame(walk.domain.getClass(), read.getClass(), "the variant");
        assertEquals(DomainFiles.hash(walk.domain.spec()), DomainFiles.hash(read.spec()), "the hash");
        String wanted = walk.domain.spec().objects().get(0).name();
        assertEquals(walk.domain.initialState(wanted), read.initialState(wanted), "the state at the start");
        assertEquals(walk.legal(walk.domain.initialState(wanted)), new Walk(read).legal(read.initialState(wanted)), "the acts");
    }
}
