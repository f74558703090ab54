package handover.domain;

import burlap.mdp.core.oo.state.OOStateUtilities;
import burlap.mdp.core.oo.state.ObjectInstance;
import handover.math.Simplex;
import java.util.List;
import java.util.random.RandomGenerator;

/**
 * A state &lt;omega_R, omega_H, O&gt;: a {@link HandoverState} and the object that the human expects. Its {@code task} object
 * has the attribute {@code expected}. Immutable, thread safe; equal by value.
 *
 * @param base the wish, the task, and h
 * @param expected omega_H, a position in the scene; -1 if nothing is left
 */
public record CommunicatedState(HandoverState base, int expected) implements TableState {

    /** A state with omega_H drawn from its h. */
    static CommunicatedState draw(HandoverState base, RandomGenerator random) {
        return new CommunicatedState(base, Simplex.sample(base.human(), base.human().length, random));
    }

    @Override
    public int numObjects() {
        return base.numObjects();
    }

    @Override
    public List<ObjectInstance> objects() {
        String name = expected < 0 ? "" : base.task().scene().objects().get(expected).name();
        return base.objects("expected", name);
    }

    @Override
    public String toString() {
        return OOStateUtilities.ooStateToString(this);
    }
}
