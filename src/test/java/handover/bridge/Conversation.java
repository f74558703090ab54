package handover.bridge;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;

/** Plays the requests of a conversation and writes down all that comes of them, without what differs from time to time. */
final class Conversation {
    private static final String LARGE = "LARGE";
    /** Fields that tell the time, or how long something took. */
    private static final Set<String> TIMES = Set.of("t", "ms", "uptime", "last_seen", "silent", "p50", "p99");
    /** Fields that change with what the conversation is not about. */
    private static final Set<String> OTHERS = Set.of("counters", "queues", "domain_hash");
    private static final String FENCE = "fence";

    private final Path folder;
    private final Path files;
    private final StringBuilder text = new StringBuilder();
    private int awaited;
    private int fences;

    /**
     * @param folder for what the bridge writes
     * @param files where domain files are looked for
     */
    Conversation(Path folder, Path files) {
        this.folder = folder;
        this.files = files;
    }

    /** The whole conversation again, from the requests in an earlier version of it. */
    String play(List<String> lines) throws Exception {
        String[] arguments = lines.stream().filter(l -> l.startsWith("$ ")).findFirst().orElseThrow().substring(2).split(" ");
        if (Files.exists(files.resolve(arguments[0]))) {
            arguments[0] = files.resolve(arguments[0]).toString();
        }
        arguments = Stream.concat(Stream.of(arguments), Stream.of("--source-timeout", "3600")).toArray(String[]::new);
        try (BridgeProcess bridge = BridgeProcess.start(folder, arguments); WireClient wire = new WireClient(bridge)) {
            wire.listen("belief", "decision", "act", "error", "scene", "episode");
            for (String line : lines) {
                if (!line.startsWith("< ") && !line.startsWith("* ")) {
                    text.append(line).append('\n');
                    step(line, bridge, wire);
                }
            }
            if (bridge.isAlive()) {
                add("* ", wire.heartbeat());
            }
        }
        return text.toString();
    }

    private void step(String line, BridgeProcess bridge, WireClient wire) throws Exception {
        if (line.startsWith(">~ ")) {
            wire.send(bytes(line.substring(3)));
            awaited++;
        } else if (line.startsWith(">> ")) {
            wire.push(bytes(line.substring(3)));
            wire.push(bytes(fence()));
            untilFence(wire);
        } else if (line.startsWith("> ")) {
            wire.send(bytes(line.substring(2)));
            for (awaited++; awaited > 0; awaited--) {
                add("< ", wire.reply());
            }
            wire.push(bytes(fence()));
            untilFence(wire);
        } else if (line.equals("! terminate")) {
            wire.must("{'v':1,'type':'hello'}"); // so that it has what was sent before
            bridge.terminate();
            for (; awaited > 0; awaited--) {
                add("< ", wire.reply());
            }
        }
    }

    private static byte[] bytes(String message) {
        return (message.equals(LARGE) ? "\"" + "x".repeat(2 << 20) + "\"" : message).getBytes(StandardCharsets.UTF_8);
    }

    /** An act that no robot has: its error is published after all that came of the messages before it. */
    private String fence() {
        return "{\"v\":1,\"type\":\"acted\",\"act\":\"FENCE\",\"status\":\"started\",\"id\":\"" + FENCE + ++fences + "\"}";
    }

    private void untilFence(WireClient wire) throws Exception {
        JsonNode event = wire.until(e -> true);
        while (!event.path("re").asText().equals(FENCE + fences)) {
            add("* ", event);
            event = wire.until(e -> true);
        }
    }

    private void add(String mark, JsonNode said) {
        String topic = mark.equals("* ") ? said.get("type").asText() + " " : "";
        text.append(mark).append(topic).append(plain(said)).append('\n');
    }

    /** The same, with times as 0, ports as 0, and six digits of each number. */
    private static String plain(JsonNode node) {
        if (node.isObject()) {
            ObjectNode tree = (ObjectNode) node;
            StringBuilder out = new StringBuilder("{");
            for (Map.Entry<String, JsonNode> e : tree.properties()) {
                out.append(out.length() > 1 ? "," : "").append('"').append(e.getKey()).append("\":");
                out.append(OTHERS.contains(e.getKey()) ? "{}" : TIMES.contains(e.getKey()) ? "0" : plain(e.getValue()));
            }
            return out.append('}').toString();
        } else if (node.isArray()) {
            StringBuilder out = new StringBuilder("[");
            node.forEach(e -> out.append(out.length() > 1 ? "," : "").append(plain(e)));
            return out.append(']').toString();
        } else if (node.isDouble()) {
            return String.format(Locale.ROOT, "%.6f", node.doubleValue()).replaceAll("-(0\\.0+)$", "$1");
        }
        return node.toString().replaceAll("tcp://127\\.0\\.0\\.1:\\d+", "tcp://127.0.0.1:0")
                .replaceAll("sensed \\d+ ms ago", "sensed 0 ms ago");
    }
}
