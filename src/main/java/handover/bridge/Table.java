package handover.bridge;

import handover.domain.HandoverDomain;
import handover.domain.InvalidParameterException;
import handover.domain.Scene;
import handover.domain.TableObject;
import handover.io.WireCode;
import handover.io.WireException;
import handover.io.WireMessage;
import handover.math.Vector3;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** Changes of what is on the table, checked. Stateless. */
final class Table {
    /** More objects than this are a mistake, and would take memory that grows with their square. */
    private static final int MOST = 200;

    private Table() {}

    /**
     * The table after a change whose positions are in its own frame.
     *
     * @param known what is on the table as far as anybody said, with what was handed over since
     * @param present what is on it without that; an object that was handed over may be added again
     * @throws WireException for an unknown object, or one that cannot be where it is said to be
     */
    static Scene after(WireMessage.SceneChange change, Scene known, Scene present) {
        HandoverDomain domain = known.domain();
        List<TableObject> objects = new ArrayList<>(known.objects());
        for (int k = 0; k < change.removed().size(); k++) {
            int i = indexOf(change.removed().get(k), objects, "removed[" + k + "]");
            objects.remove(i);
        }
        int k = 0;
        for (var moved : change.moved().entrySet()) {
            int i = indexOf(moved.getKey(), objects, "objects[" + k + "].name");
            TableObject there = place(objects.get(i), moved, "objects[" + k + "].position");
            check(domain, there, "objects[" + k++ + "]");
            objects.set(i, there);
        }
        for (k = 0; k < change.added().size(); k++) {
            TableObject added = change.added().get(k);
            boolean back = present.indexOf(added.name()) < 0 && objects.removeIf(o -> o.name().equals(added.name()));
            if (!back && objects.stream().anyMatch(o -> o.name().equals(added.name()))) {
                throw new WireException(WireCode.BAD_FIELD, "added[" + k + "].name", "expected a name that no other object has, got "
                        + added.name());
            }
            check(domain, added, "added[" + k + "]");
            objects.add(added);
        }
        if (objects.size() > Math.max(MOST, domain.start().size())) {
            throw new WireException(WireCode.BAD_FIELD, "added", "expected at most " + MOST + " objects in all, got "
                    + objects.size());
        }
        if (objects.isEmpty()) {
            throw new WireException(WireCode.BAD_FIELD, "removed", "expected at least one object that stays");
        }
        return domain.scene(objects);
    }

    /**
     * The part of a table that is left in an episode: what was on its table and still is, as it is now, and what was added.
     *
     * @param before the table of the episode
     * @param after all objects after the change
     */
    static Scene left(Scene before, WireMessage.SceneChange change, Scene after) {
        Set<String> added = change.added().stream().map(TableObject::name).collect(Collectors.toSet());
        List<TableObject> objects = after.objects().stream()
                .filter(o -> before.indexOf(o.name()) >= 0 || added.contains(o.name())).toList();
        return objects.equals(before.objects()) ? before : before.domain().scene(objects);
    }

    /** Whether two tables have the same objects in the same order, wherever they are. */
    static boolean sameObjects(Scene one, Scene other) {
        return one == other || one.size() == other.size() && IntStream.range(0, one.size()).allMatch(i ->
                one.objects().get(i).at(other.objects().get(i).position()).equals(other.objects().get(i)));
    }

    private static int indexOf(String name, List<TableObject> objects, String path) {
        for (int i = 0; i < objects.size(); i++) {
            if (objects.get(i).name().equals(name)) {
                return i;
            }
        }
        throw new WireException(WireCode.UNKNOWN_OBJECT, path, "expected an object that is on the table, one of "
                + String.join(", ", objects.stream().map(TableObject::name).toList()) + ", got \"" + name + "\"");
    }

    private static TableObject place(TableObject object, Map.Entry<String, Vector3> moved, String path) {
        try {
            return object.at(moved.getValue());
        } catch (InvalidParameterException e) {
            throw new WireException(WireCode.BAD_FIELD, path + e.field().replaceFirst("^position", ""), e.problem());
        }
    }

    /** Whether the domain could have this object from the start. */
    private static void check(HandoverDomain domain, TableObject object, String path) {
        try {
            domain.spec().with(s -> {
                s.objects = List.of(object);
                s.prior = Map.of();
            });
        } catch (InvalidParameterException e) {
            throw new WireException(WireCode.BAD_FIELD, e.field().replaceFirst("^objects\\[0\\]", path), e.problem());
        }
    }
}
