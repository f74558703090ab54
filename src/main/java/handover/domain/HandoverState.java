package handover.domain;

import burlap.mdp.core.oo.state.OOStateUtilities;
import burlap.mdp.core.oo.state.ObjectInstance;
import burlap.mdp.core.state.State;
import burlap.mdp.singleagent.pomdp.beliefstate.EnumerableBeliefState;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * A state &lt;omega, O, h&gt; as a BURLAP object-oriented state: one object of class {@code object} for each thing on the
 * table, with its position and how much the human expects it, and one of class {@code task} for what is wanted and the
 * rest of what is known. Where the human may misperceive acts, h is hidden too, and so is the task as they see it; the task
 * object then has the attribute {@code understood}, what they take to be open. Immutable, thread safe; equal by value.
 */
public final class HandoverState implements TableState {
    public static final String CLASS_OBJECT = "object";
    public static final String CLASS_TASK = "task";

    private final int wanted;
    private final Task task;
    private final double[] human;
    private final Task seen;

    /**
     * A state in which the human sees the task as it is.
     *
     * @param wanted omega, the position in the scene of the object that the human wants; -1 if there is none left
     * @param task the discrete part of what is known
     * @param human h, one entry per object; not copied, must not be modified
     */
    public HandoverState(int wanted, Task task, double[] human) {
        this(wanted, task, human, task);
    }

    /**
     * @param seen the task as the human sees it; the same as {@code task} but for what is open
     */
    public HandoverState(int wanted, Task task, double[] human, Task seen) {
        this.wanted = wanted;
        this.task = task;
        this.human = human;
        this.seen = seen;
    }

    /** The wish and what is known, of a state of any variant. */
    public static HandoverState of(State s) {
        return s instanceof CommunicatedState c ? c.base() : (HandoverState) s;
    }

    /** The known discrete part of a state or of any belief over states that share it. */
    public static Task taskOf(State s) {
        return s instanceof EnumerableBeliefState b ? taskOf(b.nonZeroBeliefs().get(0).s) : of(s).task;
    }

    /** omega, the position in the scene of the object that the human wants; -1 if there is none left. */
    public int wanted() {
        return wanted;
    }

    public Task task() {
        return task;
    }

    /** h, one entry per object; must not be modified. */
    public double[] human() {
        return human;
    }

    /** The task as the human sees it, who may have missed or misread acts. */
    public Task seen() {
        return seen;
    }

    @Override
    public int numObjects() {
        return human.length + 1;
    }

    @Override
    public List<ObjectInstance> objects() {
        return objects(null, null);
    }

    /** The objects, the task with one more attribute unless {@code key} is null. */
    List<ObjectInstance> objects(String key, Object value) {
        List<ObjectInstance> all = new ArrayList<>();
        for (int i = 0; i < human.length; i++) {
            TableObject o = task.scene().objects().get(i);
            Map<Object, Object> values = new LinkedHashMap<>();
            values.put("x", o.position().x());
            values.put("y", o.position().y());
            values.put("z", o.position().z());
            values.put("humanBelief", human[i]);
            all.add(new Instance(CLASS_OBJECT, o.name(), values));
        }
        Map<Object, Object> values = new LinkedHashMap<>();
        values.put("wanted", wanted < 0 ? "" : task.scene().objects().get(wanted).name());
        values.put("reference", task.reference() == null ? "" : task.reference().toString());
        values.put("answer", task.answer());
        values.put("target", task.target() == null ? "" : task.target());
        values.put("progress", task.progress());
        values.put("signal", task.signal());
        values.put("handovers", task.handovers());
        values.put("done", task.done());
        if (!task.scene().perceivedExactly()) {
            values.put("understood", seen.reference() == null ? "" : seen.reference().toString());
        }
        if (key != null) {
            values.put(key, value);
        }
        all.add(new Instance(CLASS_TASK, CLASS_TASK, values));
        return all;
    }

    @Override
    public boolean equals(Object o) {
        return o instanceof HandoverState s && wanted == s.wanted && task.equals(s.task) && seen.equals(s.seen)
                && Arrays.equals(human, s.human);
    }

    @Override
    public int hashCode() {
        return 31 * (31 * wanted + task.hashCode()) + Arrays.hashCode(human);
    }

    @Override
    public String toString() {
        return OOStateUtilities.ooStateToString(this);
    }

    /** One object of the state. */
    private record Instance(String className, String name, Map<Object, Object> values) implements ObjectInstance {
        @Override
        public ObjectInstance copyWithName(String objectName) {
            return new Instance(className, objectName, values);
        }

        @Override
        public List<Object> variableKeys() {
            return List.copyOf(values.keySet());
        }

        @Override
        public Object get(Object key) {
            return values.get(key);
        }

        @Override
        public ObjectInstance copy() {
            return this;
        }

        @Override
        public String toString() {
            return OOStateUtilities.objectInstanceToString(this);
        }
    }
}
