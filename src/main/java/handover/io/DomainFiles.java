package handover.io;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import handover.domain.ActParameters;
import handover.domain.DomainSpec;
import handover.domain.HandoverDomain;
import handover.domain.TableObject;
import handover.math.Vector3;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;

/**
 * Domain files: a {@link DomainSpec} as JSON, of which a file needs to give only what differs from the defaults, and
 * human files: people who differ from what the planner believes of them. The JSON Schemas for editors are in
 * {@code domains/schema}. Thread safe.
 */
public final class DomainFiles {
    private static final Shape SHAPE = new Shape("a domain file");
    private static final Pattern VERB = Pattern.compile("[a-z][a-z0-9_]*");
    private static final int HASH_DIGITS = 16;

    private DomainFiles() {}

    /**
     * Reads a domain.
     *
     * @param nameOrPath a file, or the name of a domain in the folder {@code domains} of the working directory or among
     *     those that come with the toolkit, for instance {@code bowls-and-spoons}, or {@code generated-N} or
     *     {@code generated-N-VARIANT} for a made-up table of N objects
     * @throws DomainFileException if there is no such domain, or with the place in the file that cannot be meant
     */
    public static DomainSpec read(String nameOrPath) {
        DomainSpec generated = GeneratedDomains.named(nameOrPath);
        if (generated != null) {
            return generated;
        }
        DomainSource source = DomainSource.find(nameOrPath);
        return fromJson(JsonText.parse(source.bytes(), source.name()), source.name());
    }

    /**
     * Reads people whose parameters differ from the planner's.
     *
     * @param planner the domain as the planner sees it
     * @return the same domain as it is with these people
     * @throws DomainFileException if there is no such file, or with the place in the file that cannot be meant
     */
    public static DomainSpec readHuman(DomainSpec planner, Path file) {
        DomainSource source = DomainSource.ofFile(file);
        Place place = Place.of(source.name());
        return HumanFile.read(planner, JsonText.parse(source.bytes(), source.name()), place).over(planner, place);
    }

    /**
     * The domain that a JSON tree describes; what it does not say is as in {@link DomainSpec#of}.
     *
     * @param json not modified
     * @param source what messages call it
     * @throws DomainFileException with the place in the tree that cannot be meant
     */
    public static DomainSpec fromJson(JsonNode json, String source) {
        Place file = Place.of(source);
        ObjectNode user = Shape.root(json, file);
        ObjectNode defaults = defaults(user.path("variant").asText(DomainSpec.BASE), file);
        user.path("acts").properties().forEach(act -> checkNewAct(act.getKey(), act.getValue(), defaults.get("acts"),
                file.key("acts").key(act.getKey())));
        ObjectNode whole = Overlay.merge(defaults, user);
        whole.path("objects").forEach(DomainFiles::addDefaultLabel);
        FrameForms.unify(whole.path("frames"), file.key("frames"));
        whole.path("adapters").forEach(DomainFiles::addDefaultMaps);
        SHAPE.check(whole, DomainSpec.class, file);
        return RecordMapper.bind(whole, DomainSpec.class, file);
    }

    /**
     * The whole domain in the format of a file, every default spelled out. {@link #fromJson} gives it back exactly,
     * unless it lacks an act of the defaults, which a file cannot take away.
     */
    public static ObjectNode toJson(DomainSpec spec) {
        return RecordMapper.tree(spec);
    }

    /** 16 hexadecimal digits that differ if anything but the description and what is said of sensors differs. */
    public static String hash(DomainSpec spec) {
        ObjectNode content = toJson(spec);
        content.remove(List.of("description", "frames", "adapters"));
        try {
            byte[] digest = MessageDigest.getInstance("SHA-256")
                    .digest(RecordMapper.canonical(content).getBytes(StandardCharsets.UTF_8));
            return HexFormat.of().formatHex(digest).substring(0, HASH_DIGITS);
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java has SHA-256", e);
        }
    }

    /**
     * Reads a domain and makes it: an instance of the variant that it names.
     *
     * @throws DomainFileException as {@link #read}, or if the variant cannot be made
     */
    public static HandoverDomain load(String nameOrPath) {
        return Variants.create(read(nameOrPath), Place.of(nameOrPath));
    }

    /** The domain that a spec describes. Throws {@link DomainFileException} if its variant cannot be made. */
    public static HandoverDomain domain(DomainSpec spec) {
        return Variants.create(spec, Place.of(spec.name()));
    }

    /** {@link DomainSpec#of} as this variant changes it, as a tree, without what it was given. */
    private static ObjectNode defaults(String variant, Place file) {
        TableObject any = new TableObject("any", new Vector3(0, 1, 0), Map.of("any", 1.0), "");
        ObjectNode tree = RecordMapper.tree(Variants.defaults(variant, DomainSpec.of("any", List.of(any)), file));
        tree.remove(List.of("name", "objects"));
        return tree;
    }

    /** An empty label means the default, which is made from the name. */
    static void addDefaultLabel(JsonNode object) {
        if (object instanceof ObjectNode fields && !fields.has("label")) {
            fields.put("label", "");
        }
    }

    /** An adapter need not rename or fix any field. */
    private static void addDefaultMaps(JsonNode adapter) {
        if (adapter instanceof ObjectNode fields) {
            for (String key : List.of("fields", "values")) {
                if (!fields.has(key)) {
                    fields.putObject(key);
                }
            }
        }
    }

    /** An act that the defaults do not have must be given in full, so that a mistyped verb is not taken for one. */
    private static void checkNewAct(String verb, JsonNode act, JsonNode defaults, Place at) {
        if (!VERB.matcher(verb).matches()) {
            throw at.error("expected the name of a type of act in lower case, got \"" + verb + "\"");
        }
        List<String> missing = new ArrayList<>(Shape.fields(ActParameters.class).keySet());
        act.fieldNames().forEachRemaining(missing::remove);
        if (!defaults.has(verb) && act.isObject() && !missing.isEmpty()) {
            List<String> known = new ArrayList<>();
            defaults.fieldNames().forEachRemaining(known::add);
            throw at.error("unknown act" + NearestKey.suggestion(verb, known) + "; a new act must also give "
                    + String.join(", ", missing));
        }
    }
}
