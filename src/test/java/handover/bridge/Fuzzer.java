package handover.bridge;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;

/** Makes messages about {@code table-line-6}, good and bad; the same seed, the same messages. */
final class Fuzzer {
    private static final List<String> OBJECTS = List.of("blue_cylinder", "red_ball", "purple_marker", "blue_ball",
            "yellow_block", "green_marker");
    private static final List<String> WORDS = List.of("red", "blue", "ball", "marker", "yes", "no", "not", "the", "one", "block",
            "green", "zebra", "");
    private static final List<String> STATUSES = List.of("started", "completed", "failed", "cancelled");

    /** Texts that are wrong wherever they stand for a number of metres, with the code that they get. */
    private static final List<String> NO_METRES = List.of("NaN", "1e308", "-1e308", "1e999", "Infinity", "\"1\"", "null", "[1]", "{}",
            "true", "1e400");

    /** Unix seconds that are still to come; a message that claims them counts as sensed when it comes. */
    private static final long FUTURE = 10_000_000_000L;

    private final SplittableRandom chance;
    private long ids;

    /**
     * A message.
     *
     * @param id that it has and nobody else, null if it has none or that is not known
     * @param code that it must get, ok if it is good, null if that is not known
     */
    record Case(byte[] bytes, String id, String code) {}

    Fuzzer(long seed) {
        chance = new SplittableRandom(seed);
    }

    /** Any message, also one of which nobody knows what it is now; such a one has another source, whose ids may be any. */
    Case next() {
        return chance.nextInt(5) > 0 ? intact()
                : new Case(mutated(bytes((chance.nextBoolean() ? sensed() : robot()).replace("\"fuzz\"", "\"wild\""))), null, null);
    }

    /** A message as it was made. */
    Case intact() {
        int kind = chance.nextInt(80);
        if (kind < 30) {
            return named(sensed(), "ok");
        } else if (kind < 40) {
            return named(robot(), null);
        } else if (kind < 44) {
            return named(message("scene", "\"added\":[{\"name\":\"extra\",\"position\":" + point() + ",\"words\":{\"red\":1}}]"), null);
        } else if (kind < 46) {
            return named(message("scene", "\"removed\":[\"extra\"]"), null);
        } else if (kind < 66) {
            return wrong();
        } else if (kind < 74) {
            byte[] noise = new byte[chance.nextInt(200)];
            chance.nextBytes(noise);
            noise = noise.length > 0 && noise[0] == '{' ? new byte[0] : noise;
            return new Case(noise, null, "not_json");
        }
        return new Case(bytes(nested()), null, null);
    }

    /** The message that was made last. */
    private Case named(String message, String code) {
        return new Case(bytes(message), "f" + (ids - 1), code);
    }

    /** Always good. */
    private String sensed() {
        return switch (chance.nextInt(9)) {
            case 7 -> message("scene", "\"objects\":[{\"name\":\"" + one(OBJECTS) + "\",\"position\":" + point() + "}]");
            case 8 -> message("speech", "\"text\":\"" + words() + "\",\"t\":" + (FUTURE + chance.nextInt(1_000_000)));
            case 0, 1, 2 -> message("speech", "\"text\":\"" + words() + "\"");
            case 3, 4 -> message("speech", "\"alternatives\":[{\"transcript\":\"" + words() + "\",\"confidence\":"
                    + chance.nextDouble() + "},{\"transcript\":\"" + words() + "\",\"confidence\":0.25}]");
            default -> message("gesture", "\"shoulder\":[0.15,1.4,0.35],\"hand\":" + point());
        };
    }

    /** Whether it can be depends on what was done before; a new episode now and then, as one without objects is dull. */
    private String robot() {
        if (chance.nextInt(20) == 0) {
            return message("begin", "\"prior\":{\"red_ball\":0.5,\"blue_ball\":0.25,\"green_marker\":0.25}");
        }
        String act = one(List.of("ASK", "POINT", "LOOK", "PICK", "WAIT", "wait"));
        String pick = chance.nextInt(3) > 0 ? "" : ",\"pick\":\"" + one(List.of("accepted", "rejected", "moving", "gone")) + "\"";
        return message("acted", "\"act\":\"" + act + "\",\"objects\":[" + (act.equals("WAIT") ? "" : "\"" + one(OBJECTS) + "\"")
                + "],\"status\":\"" + one(STATUSES) + "\"" + pick);
    }

    private Case wrong() {
        return switch (chance.nextInt(11)) {
            case 9 -> named(message("scene", "\"objects\":[{\"name\":\"unicorn\",\"position\":" + point() + "}]"), "unknown_object");
            case 10 -> named(message("scene", "\"added\":[{\"name\":\"cup\",\"position\":" + point() + "}]"), "missing_field");
            case 0 ->
                    new Case(bytes(message("gesture", "\"shoulder\":[0,1.4,0.3],\"hand\":[0,1," + one(NO_METRES) + "]")), null, "bad_field");
            case 1 ->
                    named(message("acted", "\"act\":\"ASK\",\"objects\":[\"unicorn" + ids + "\"],\"status\":\"started\""), "unknown_object");
            case 2 -> named(message("acted", "\"act\":\"DANCE\",\"objects\":[],\"status\":\"started\""), "illegal_act");
            case 3 ->
                    named(message("gesture", "\"shoulder\":[0,1.4,0.3],\"hand\":[0,1,1],\"frame\":\"moon\""), "unknown_frame");
            case 4 -> named(message("sing", "\"text\":\"la\""), "bad_type");
            case 5 -> named(message("speech", "\"txt\":\"red\""), "missing_field");
            case 6 -> named(message("speech", "\"text\":\"red\",\"t\":" + chance.nextInt(1_000_000)), "stale");
            case 7 -> new Case(bytes("{\"v\":" + (2 + chance.nextInt(9)) + ",\"type\":\"state\"}"), null, "bad_version");
            default ->
                    new Case(("{\"v\":1,\"type\":\"speech\",\"text\":\"" + (char) 0xff + "\"}").getBytes(StandardCharsets.ISO_8859_1), null, "not_json");
        };
    }

    private String nested() {
        int depth = chance.nextInt(2000);
        return message("state", "\"x\":" + "[".repeat(depth) + "{\"a\":".repeat(depth) + "1" + "}".repeat(depth) + "]".repeat(depth));
    }

    private byte[] mutated(byte[] message) {
        byte[] m = message.clone();
        for (int k = 1 + chance.nextInt(3); k > 0 && m.length > 0; k--) {
            switch (chance.nextInt(4)) {
                case 0 -> m[chance.nextInt(m.length)] = (byte) chance.nextInt(256);
                case 1 -> m[chance.nextInt(m.length)] = (byte) "{}[],:\"0-.eE".charAt(chance.nextInt(12));
                case 2 -> m = Arrays.copyOf(m, chance.nextInt(m.length));
                default -> {
                    int at = chance.nextInt(m.length);
                    System.arraycopy(m, at, m, chance.nextInt(m.length), Math.min(m.length - at, 1)); }
            }
        }
        return m;
    }

    private String message(String type, String fields) {
        return "{\"v\":1,\"type\":\"" + type + "\",\"id\":\"f" + ids++ + "\",\"source\":\"fuzz\"," + fields + "}";
    }

    private String words() {
        StringBuilder text = new StringBuilder();
        for (int k = chance.nextInt(5); k > 0; k--) {
            text.append(one(WORDS)).append(chance.nextInt(6) > 0 ? " " : ", ");
        }
        return text.toString();
    }

    private String point() {
        return "[" + (chance.nextDouble() - 0.5) + "," + chance.nextDouble() + "," + (chance.nextDouble() - 0.5) + "]";
    }

    private String one(List<String> of) {
        return of.get(chance.nextInt(of.size()));
    }

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }
}
