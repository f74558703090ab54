package handover.domain;

import java.util.Comparator;
import java.util.List;
import java.util.Objects;

/**
 * The discrete part of what is known: objects on the table, the reference that this step's answer is about and the
 * answer, pick progress, handovers. One instance per value and scene, which caches what each act does from here.
 * Immutable to the outside, thread safe.
 */
public final class Task {
    /**
     * The values of a task.
     *
     * @param reference what an answer in this step is or was about, null if nothing
     * @param answer the answer that was given
     * @param target name of the object that the robot is reaching for, null if none
     * @param progress increments made towards it
     * @param signal what the last act did as a pick
     * @param handovers accepted so far
     * @param done whether the episode is over
     */
    record Key(Act reference, Answer answer, String target, int progress, PickSignal signal, int handovers,
            boolean done) {
        static final Key START = new Key(null, Answer.NONE, null, 0, PickSignal.NONE, 0, false);
    }

    private final Scene scene;
    private final Key key;
    private final int hash;
    /** These caches are filled on demand, racily on purpose: the values are immutable and equal whoever computes them. */
    private final ActEffect[] effects;
    private final Answers[] expected;
    private final Task[] answered = new Task[Answer.values().length];
    private final Task[] completed = new Task[2];
    private int[] byReward;

    Task(Scene scene, Key key) {
        this.scene = scene;
        this.key = key;
        this.hash = Objects.hash(scene, key);
        this.effects = key.done ? new ActEffect[0] : new ActEffect[scene.acts().size()];
        this.expected = key.done || scene.perceivedExactly() ? new Answers[0] : new Answers[effects.length];
    }

    public Scene scene() {
        return scene;
    }

    /** What an answer in this step is or was about; null if nothing. */
    public Act reference() {
        return key.reference;
    }

    public Answer answer() {
        return key.answer;
    }

    /** The last communicative act that was not answered yet; null if there is none. */
    public Act openReference() {
        return key.answer == Answer.NONE ? key.reference : null;
    }

    /** Name of the object that the robot is reaching for; null if none. */
    public String target() {
        return key.target;
    }

    /** Increments made towards the target. */
    public int progress() {
        return key.progress;
    }

    public PickSignal signal() {
        return key.signal;
    }

    /** Objects that were handed over and accepted. */
    public int handovers() {
        return key.handovers;
    }

    /** Whether the episode is over. */
    public boolean done() {
        return key.done;
    }

    /** What is legal now: every act on offer; when the episode is over, none but an empty WAIT for BURLAP's sake. */
    public List<ActModel> legalActs() {
        return key.done ? List.of(scene.domain().idle()) : scene.acts();
    }

    /** What the act with this index in the scene does from here. */
    public ActEffect effect(int act) {
        ActEffect e = effects[act];
        if (e == null) {
            e = scene.domain().effect(this, scene.acts().get(act));
            effects[act] = e;
        }
        return e;
    }

    /** What an act does from here; throws {@link IllegalArgumentException} if it is not on offer. */
    public ActEffect effect(Act act) {
        ActModel model = scene.model(act);
        if (model == null || key.done) {
            throw new IllegalArgumentException(act + " is not legal: "
                    + (key.done ? "the episode is over" : "on the table are " + scene));
        }
        return effect(model.index());
    }

    /** The indices of the acts that are no picks, from the highest reward to the lowest; not to be modified. */
    public int[] byReward() {
        int[] order = byReward;
        if (order == null) {
            order = legalActs().stream().filter(m -> !m.isPick()).map(ActModel::index)
                    .sorted(Comparator.comparingDouble(a -> -effect(a).reward())).mapToInt(a -> a).toArray();
            byReward = order;
        }
        return order;
    }

    /** This task after an answer. */
    public Task answered(Answer answer) {
        Task t = answered[answer.ordinal()];
        if (t == null) {
            t = with(new Key(key.reference, answer, key.target, key.progress, key.signal, key.handovers, key.done));
            answered[answer.ordinal()] = t;
        }
        return t;
    }

    /** This task once the pick under way completed, of the wanted object or of another one (MODEL 5). */
    public Task completed(boolean right) {
        int k = right ? 1 : 0;
        if (completed[k] == null) {
            completed[k] = scene.domain().complete(this, right);
        }
        return completed[k];
    }

    /** This task with the pick given up. */
    public Task cancelled() {
        return with(new Key(key.reference, key.answer, null, 0, PickSignal.NONE, key.handovers, key.done));
    }

    /** This task on another table; what is about an object that is not there any more is dropped. */
    public Task on(Scene other) {
        Act reference = key.reference != null && other.model(key.reference) != null ? key.reference : null;
        boolean reaching = key.target != null && other.indexOf(key.target) >= 0;
        PickSignal signal = reaching || key.target == null ? key.signal : PickSignal.NONE;
        return other.task(new Key(reference, reference == null ? Answer.NONE : key.answer, reaching ? key.target : null,
                reaching ? key.progress : 0, signal, key.handovers, key.done || other.size() == 0));
    }

    /** What of this task matters to what comes next: without what the step that is over was about. */
    public Task settled() {
        return with(new Key(openReference(), Answer.NONE, key.target, key.progress, PickSignal.NONE, key.handovers, key.done));
    }

    /**
     * Who would answer what to the act with this index, on average over what the human may take it for.
     */
    public Answers expectedAnswers(int act) {
        List<Percept> percepts = scene.percepts(scene.acts().get(act));
        if (percepts.size() == 1) {
            return effect(percepts.get(0).act().index()).answers();
        }
        Answers e = expected[act];
        if (e == null) {
            e = Answers.average(percepts.stream().map(p -> effect(p.act().index()).answers()).toList(),
                    percepts.stream().mapToDouble(Percept::probability).toArray());
            expected[act] = e;
        }
        return e;
    }

    /** The task with other values on the same scene. */
    Task with(Key other) {
        return other.equals(key) ? this : scene.task(other);
    }

    @Override
    public boolean equals(Object o) {
        return this == o || o instanceof Task t && hash == t.hash && key.equals(t.key) && scene.equals(t.scene);
    }

    @Override
    public int hashCode() {
        return hash;
    }

    @Override
    public String toString() {
        return key.toString();
    }
}
