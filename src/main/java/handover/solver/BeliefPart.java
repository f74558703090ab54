package handover.solver;

import handover.domain.Act;
import handover.domain.Scene;
import handover.domain.TableObject;
import handover.domain.Task;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.List;

/**
 * The discrete part of what is known, as far as the future depends on it: stored beliefs are compared only within one part.
 * An answered reference and the last pick signal are not in it, because no seam of a domain looks at them any more. Immutable.
 *
 * @param depends hash of all that the part's stored decisions depend on besides the domain's parameters: objects with
 *     positions, words and labels in table order, open reference, pick under way, handovers; equal where they hold
 * @param objects names, in table order
 * @param reference the open reference, empty if none
 * @param target what the robot is reaching for, empty if nothing
 * @param progress increments made towards it
 * @param handovers accepted so far
 */
public record BeliefPart(String depends, List<String> objects, String reference, String target, int progress, int handovers) {
    private static final int HASH_DIGITS = 16;

    public BeliefPart {
        objects = List.copyOf(objects);
    }

    /** The part of a task. */
    static BeliefPart of(Task task) {
        return of(task.scene(), task.openReference(), task.target(), task.progress(), task.handovers());
    }

    /** The part of a task with another reference and target. */
    static BeliefPart of(Scene scene, Act reference, String target, int progress, int handovers) {
        StringBuilder text = new StringBuilder();
        for (TableObject o : scene.objects()) {
            text.append(o.name()).append('\n').append(o.position()).append('\n').append(o.words()).append('\n')
                    .append(o.label()).append('\n');
        }
        String open = reference == null ? "" : reference.toString();
        String reach = target == null ? "" : target;
        text.append(open).append('\n').append(reach).append('\n').append(progress).append('\n').append(handovers);
        return new BeliefPart(hash(text.toString()), scene.objects().stream().map(TableObject::name).toList(), open, reach,
                progress, handovers);
    }

    /** Coordinates of a stored belief. */
    int dimensions() {
        return 2 * objects.size();
    }

    private static String hash(String text) {
        try {
            byte[] digest = MessageDigest.getInstance("SHA-256").digest(text.getBytes(StandardCharsets.UTF_8));
            return HexFormat.of().formatHex(digest).substring(0, HASH_DIGITS);
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java has SHA-256", e);
        }
    }
}
