package handover.bridge;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.locks.LockSupport;
import org.zeromq.SocketType;
import org.zeromq.ZContext;
import org.zeromq.ZMQ;

/**
 * Measures a bridge process from outside: {@code BridgeLoad flood SECONDS RATE} pushes gestures and counts what became of them;
 * {@code BridgeLoad latency SECONDS DEADLINE_MS} decides while four sources gesture at 30 Hz and somebody speaks.
 */
public final class BridgeLoad {
    private static final ObjectMapper MAPPER = new ObjectMapper();
    private static final String GESTURE = "{\"v\":1,\"type\":\"gesture\",\"source\":\"%s\",\"hand\":[%.3f,0.9,0.15],"
            + "\"shoulder\":[0.15,1.4,0.35]}";

    private final ZContext context = new ZContext();
    private final Process process;
    private final JsonNode sockets;
    private final ZMQ.Socket request;

    private BridgeLoad(String log, String... more) throws IOException {
        List<String> command = new ArrayList<>(List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-Xmx256m",
                "-cp", System.getProperty("java.class.path"), "handover.cli.Main", "bridge", "table-line-6", "--command",
                "tcp://127.0.0.1:*", "--stream", "tcp://127.0.0.1:*", "--events", "tcp://127.0.0.1:*", "--log", log));
        command.addAll(List.of(more));
        process = new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.INHERIT).start();
        BufferedReader out = new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
        sockets = MAPPER.readTree(out.readLine()).get("sockets");
        request = socket(SocketType.REQ, "command");
        ask("{\"v\":1,\"type\":\"begin\"}");
    }

    private ZMQ.Socket socket(SocketType type, String name) {
        ZMQ.Socket socket = context.createSocket(type);
        socket.setLinger(0);
        if (type == SocketType.SUB) {
            socket.subscribe("belief");
        }
        socket.connect(sockets.get(name).asText());
        return socket;
    }

    private JsonNode ask(String json) throws IOException {
        request.send(json);
        return MAPPER.readTree(request.recv());
    }

    /** Runs one of the measurements. */
    public static void main(String[] args) throws IOException, InterruptedException {
        int seconds = Integer.parseInt(args[1]);
        int value = Integer.parseInt(args[2]);
        Path log = Files.createTempDirectory("bridge-load").resolve("log.jsonl");
        BridgeLoad load = new BridgeLoad(args.length > 3 ? args[3] : log.toString(), "--solver", "poss:H=3,C=10");
        try {
            if (args[0].equals("flood")) {
                load.flood(seconds, value);
            } else {
                load.latency(seconds, value);
            }
        } finally {
            load.context.close();
            load.process.destroy();
            load.process.waitFor();
            Files.deleteIfExists(log);
        }
    }

    private void flood(int seconds, int rate) throws IOException, InterruptedException {
        ZMQ.Socket push = socket(SocketType.PUSH, "stream");
        long start = System.nanoTime();
        long sent = 0;
        for (int s = 0; s < seconds; s++) {
            while (System.nanoTime() - start < (s + 1) * 1_000_000_000L) {
                long due = (System.nanoTime() - start) * rate / 1_000_000_000L;
                for (; sent < due; sent++) {
                    push.send(String.format(Locale.ROOT, GESTURE, "cam" + sent % 4, 0.25 + sent % 100 * 1e-3));
                }
                LockSupport.parkNanos(200_000);
            }
            if (s % 10 == 9) {
                System.out.println(s + 1 + " s: sent " + sent + ", " + counters() + ", resident " + resident());
            }
        }
        double took = (System.nanoTime() - start) / 1e9;
        Thread.sleep(3000);
        System.out.printf(Locale.ROOT, "sent %d in %.1f s (%.0f a second), %s%n", sent, took, sent / took, counters());
    }

    private String counters() throws IOException {
        JsonNode c = ask("{\"v\":1,\"type\":\"state\"}").get("counters");
        return "streamed " + c.path("streamed") + " = applied " + (c.path("applied").asLong() - 1) + " + shed " + c.path("shed").asLong()
                + " + errors " + c.path("errors").asLong();
    }

    private String resident() throws IOException {
        return Files.readAllLines(Path.of("/proc/" + process.pid() + "/status")).stream().filter(l -> l.startsWith("VmRSS"))
                .findFirst().orElse("");
    }

    private void latency(int seconds, int deadlineMs) throws IOException, InterruptedException {
        Thread sensors = new Thread(() -> gesture(seconds), "sensors");
        sensors.start();
        ZMQ.Socket push = socket(SocketType.PUSH, "stream");
        ZMQ.Socket events = socket(SocketType.SUB, "events");
        Thread.sleep(500);
        List<Double> published = new ArrayList<>();
        List<Double> late = new ArrayList<>();
        int fallbacks = 0;
        long end = System.nanoTime() + seconds * 1_000_000_000L;
        for (int k = 0; System.nanoTime() < end; k++) {
            long asked = System.nanoTime();
            JsonNode decision = ask("{\"v\":1,\"type\":\"decide\",\"deadline_ms\":" + deadlineMs + "}");
            late.add((System.nanoTime() - asked) / 1e6 - deadlineMs);
            fallbacks += decision.get("fallback").asBoolean() ? 1 : 0;
            while (events.recv(ZMQ.DONTWAIT) != null) {
                continue;
            }
            long said = System.nanoTime();
            push.send("{\"v\":1,\"type\":\"speech\",\"id\":\"s" + k + "\",\"text\":\"the red one\"}");
            String re = "\"re\":\"s" + k + "\"";
            for (String event = events.recvStr(); !event.contains(re); event = events.recvStr()) {
                continue;
            }
            published.add((System.nanoTime() - said) / 1e6);
            if (k % 20 == 19) {
                ask("{\"v\":1,\"type\":\"begin\"}");
            }
        }
        sensors.join();
        System.out.println("decide, ms after the deadline: " + quantiles(late) + ", fallbacks " + fallbacks);
        System.out.println("speech sent to belief received, ms: " + quantiles(published));
    }

    private void gesture(int seconds) {
        ZMQ.Socket push = socket(SocketType.PUSH, "stream");
        long start = System.nanoTime();
        for (int k = 0; k < seconds * 120; k++) {
            long wait = start + k * 1_000_000_000L / 120 - System.nanoTime();
            LockSupport.parkNanos(Math.max(0, wait));
            push.send(String.format(Locale.ROOT, GESTURE, "cam" + k % 4, 0.25 + k % 100 * 1e-3));
        }
    }

    private static String quantiles(List<Double> ms) {
        double[] sorted = ms.stream().mapToDouble(x -> x).sorted().toArray();
        int n = sorted.length;
        return String.format(Locale.ROOT, "n %d, p50 %.2f, p99 %.2f, max %.2f", n, sorted[n / 2],
                sorted[(int) Math.ceil(0.99 * n) - 1], Arrays.stream(sorted).max().orElseThrow());
    }
}
