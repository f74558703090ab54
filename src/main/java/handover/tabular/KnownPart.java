package handover.tabular;

import handover.domain.Act;
import handover.domain.Answer;
import handover.domain.HandoverDomain;
import handover.domain.HandoverState;
import handover.domain.Scene;
import handover.domain.Task;
import handover.math.Simplex;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * One value of the known part of a handover state that the flat model tells apart: a task and the human's belief that stand for all
 * that are merged into it. Immutable; the array must not be modified.
 *
 * @param number counted from 0, the start
 * @param label for state names, empty for the start
 */
record KnownPart(int number, String label, Task task, double[] human) {

    /** What is told apart. */
    private record Key(Scene scene, Act reference, Answer answer, Act contrast, String target, int progress, int handovers) {}

    /** All known parts that were met, merged as the flat model's detail says. Used by one thread. */
    static final class Parts {
        private final HandoverDomain domain;
        private final FlatHandover.Detail detail;
        private final double tolerance;
        private final Map<Key, List<KnownPart>> known = new LinkedHashMap<>();
        private final List<KnownPart> all = new ArrayList<>();

        Parts(HandoverDomain domain, FlatHandover.Detail detail, double tolerance) {
            this.domain = domain;
            this.detail = detail;
            this.tolerance = tolerance;
            of(domain.task(domain.start()), Simplex.uniform(domain.start().size()));
        }

        int size() {
            return all.size();
        }

        KnownPart get(int number) {
            return all.get(number);
        }

        /** The part that the known part of a state is merged into. */
        KnownPart of(HandoverState state) {
            return of(state.task(), state.human());
        }

        private KnownPart of(Task task, double[] human) {
            boolean wish = detail == FlatHandover.Detail.WISH;
            boolean contrast = domain.spec().speech().contrast() > 0;
            Key key = new Key(task.scene(), wish ? null : task.openReference(), wish ? Answer.NONE : task.answer(),
                    wish || !contrast ? null : task.reference(), task.target(), task.progress(), task.handovers());
            List<KnownPart> same = known.computeIfAbsent(key, k -> new ArrayList<>());
            double[] h = detail == FlatHandover.Detail.EXPECTATION ? human : recent(task, key.reference);
            KnownPart nearest = null;
            for (KnownPart part : same) {
                double d = Simplex.l1(part.human, h);
                if (d <= tolerance && (nearest == null || d < Simplex.l1(nearest.human, h))) {
                    nearest = part;
                }
            }
            if (nearest == null) {
                nearest = new KnownPart(all.size(), label(key, same.size()), representative(task, key), h);
                same.add(nearest);
                all.add(nearest);
            }
            return nearest;
        }

        /** A belief that follows from what the human saw last, and forgets what was before. */
        private double[] recent(Task task, Act reference) {
            Scene scene = task.scene();
            double[] uniform = Simplex.uniform(scene.size());
            Act last = task.target() == null ? reference : Act.of("PICK", task.target());
            return last == null ? uniform : domain.understood(scene.model(last), uniform);
        }

        /** The task itself, or one like it that forgets what was asked. */
        private Task representative(Task task, Key key) {
            boolean forget = detail == FlatHandover.Detail.WISH && task.target() == null && task.handovers() == 0;
            return forget && key.scene.equals(domain.start()) ? domain.task(domain.start()) : task;
        }

        private static String label(Key key, int cluster) {
            StringBuilder text = new StringBuilder();
            text.append(key.handovers == 0 ? "" : "." + key.handovers + "-of-" + key.scene);
            text.append(key.reference == null ? "" : "." + key.reference);
            text.append(key.answer == Answer.NONE ? "" : "." + key.answer);
            text.append(key.contrast == null || key.contrast.equals(key.reference) ? "" : "." + key.contrast);
            text.append(key.target == null ? "" : ".reach" + key.progress + "-" + key.target);
            return text.append(cluster == 0 ? "" : ".h" + cluster).toString();
        }
    }
}
