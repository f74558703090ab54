package handover.io;

import com.fasterxml.jackson.databind.node.ObjectNode;
import handover.domain.TableObject;
import handover.math.Vector3;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** The fields of a change of the table: objects in the form of a domain file, or their names and positions. */
final class SceneFields {
    private static final Shape SHAPE = new Shape("an object of a domain file");
    private static final String METRES = "number of metres";

    private SceneFields() {}

    static WireMessage read(WireMessage.Envelope envelope, Fields f) {
        if (!f.has("objects") && !f.has("removed") && !f.has("added")) {
            throw new FieldException(true, "objects", "expected at least one of objects, removed and added");
        }
        Map<String, Vector3> moved = new LinkedHashMap<>();
        for (Fields object : f.has("objects") ? f.objects("objects") : List.<Fields>of()) {
            if (moved.put(object.text("name"), object.vector("position", METRES)) != null) {
                throw object.wrong("name", "each object once");
            }
        }
        List<TableObject> added = (f.has("added") ? f.objects("added") : List.<Fields>of()).stream().map(SceneFields::object)
                .toList();
        return new WireMessage.SceneChange(envelope, moved, f.has("removed") ? List.copyOf(f.texts("removed")) : List.of(),
                added, f.textOrNull("frame"));
    }

    private static TableObject object(Fields f) {
        ObjectNode tree = f.node().deepCopy();
        DomainFiles.addDefaultLabel(tree);
        for (String key : Shape.fields(TableObject.class).keySet()) {
            if (!tree.hasNonNull(key)) {
                throw new FieldException(true, f.path() + "." + key, "this field is missing");
            }
        }
        Place place = Place.of("message");
        try {
            SHAPE.check(tree, TableObject.class, place);
            return RecordMapper.bind(tree, TableObject.class, place);
        } catch (DomainFileException e) {
            throw new FieldException(false, f.path() + (e.path().isEmpty() ? "" : "." + e.path()), e.problem());
        }
    }
}
