package handover.solver;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.ActModel;
import handover.domain.Scene;
import handover.domain.Task;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/**
 * Where a belief lies among stored beliefs: in which part, under which symmetries, at which coordinates. What follows from the
 * task alone is kept for tasks met before. Thread safe.
 */
public final class BeliefSpace {
    /** Tasks remembered; more than that only if objects are moved again and again. */
    private static final int MOST_TASKS = 10_000;

    private final BeliefMetric metric;
    private final Map<Task, Located> located = new ConcurrentHashMap<>();
    private final Map<Scene, List<Symmetry>> symmetries = new ConcurrentHashMap<>();

    /**
     * A task's place.
     *
     * @param part of the canonical task, one of those that the symmetries make of this one
     * @param images the symmetries that lead there, at least one
     */
    record Located(BeliefPart part, List<Symmetry> images) {}

    public BeliefSpace(BeliefMetric metric) {
        this.metric = metric;
    }

    BeliefMetric metric() {
        return metric;
    }

    Located locate(Task task) {
        Located at = located.get(task);
        if (at == null) {
            if (located.size() >= MOST_TASKS) {
                located.clear();
                symmetries.clear();
            }
            at = canonical(task);
            located.put(task, at);
        }
        return at;
    }

    /** How many permutations of a scene's objects one stored belief serves, at least 1. */
    public int symmetries(Scene scene) {
        return of(scene).size();
    }

    private List<Symmetry> of(Scene scene) {
        return symmetries.computeIfAbsent(scene, Symmetries::of);
    }

    /** Of all tasks that the symmetries make of this one: the one whose reference and target come first. */
    private Located canonical(Task task) {
        Scene scene = task.scene();
        ActModel reference = task.openReference() == null ? null : scene.model(task.openReference());
        int target = task.target() == null ? -1 : scene.indexOf(task.target());
        int stride = scene.size() + 1;
        int best = Integer.MAX_VALUE;
        List<Symmetry> images = new ArrayList<>();
        for (Symmetry s : of(scene)) {
            int act = reference == null ? -1 : s.acts()[reference.index()];
            int key = (act + 1) * stride + (target < 0 ? 0 : s.objects()[target] + 1);
            if (key < best) {
                best = key;
                images.clear();
            }
            if (key == best) {
                images.add(s);
            }
        }
        Act open = best / stride == 0 ? null : scene.acts().get(best / stride - 1).act();
        String reach = best % stride == 0 ? null : scene.objects().get(best % stride - 1).name();
        return new Located(BeliefPart.of(scene, open, reach, task.progress(), task.handovers()), List.copyOf(images));
    }

    /** The belief with its decision as it is stored. The decision's acts must be those of the belief's scene. */
    public StoredBelief stored(HandoverBelief belief, Decision decision) {
        Located at = locate(belief.task());
        Symmetry image = at.images.get(0);
        Scene scene = belief.scene();
        float[] coordinates = new float[2 * scene.size()];
        metric.coordinates(belief, image.objects(), coordinates);
        float[] values = new float[scene.acts().size()];
        for (ActModel m : scene.acts()) {
            Double value = decision.values().get(m.act());
            values[image.acts()[m.index()]] = value == null ? Float.NaN : value.floatValue();
        }
        return new StoredBelief(at.part, coordinates, values, image.acts()[scene.model(decision.act()).index()]);
    }
}
