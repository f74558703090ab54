package handover.domain;

import burlap.mdp.core.oo.state.OOState;
import burlap.mdp.core.oo.state.OOStateUtilities;
import burlap.mdp.core.oo.state.ObjectInstance;
import burlap.mdp.core.state.State;
import burlap.statehashing.HashableState;
import java.util.List;

/** What follows for BURLAP from the list of a state's objects. Implementations are immutable values, so a copy is the same. */
interface TableState extends OOState, HashableState {
    @Override
    default ObjectInstance object(String name) {
        return OOStateUtilities.objectWithName(objects(), name);
    }

    @Override
    default List<ObjectInstance> objectsOfClass(String className) {
        return objects().stream().filter(o -> o.className().equals(className)).toList();
    }

    @Override
    default List<Object> variableKeys() {
        return OOStateUtilities.flatStateKeys(this);
    }

    @Override
    default Object get(Object key) {
        return OOStateUtilities.get(this, key);
    }

    @Override
    default State copy() {
        return this;
    }

    @Override
    default State s() {
        return this;
    }
}
