package handover.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import handover.domain.Adapter;
import handover.domain.HandoverDomain;
import handover.io.DomainFiles;
import handover.solver.Confirm;
import java.nio.charset.StandardCharsets;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.zeromq.SocketType;
import org.zeromq.ZContext;
import org.zeromq.ZMQ;

/** A publisher of somebody else is read as the domain file's adapters say. */
class FeedTest {
    private static final HandoverDomain DOMAIN = DomainFiles.domain(DomainFiles.read("table-line-6").with(s -> s.adapters = Map.of(
            "speech", new Adapter(Adapter.Type.SPEECH, Map.of("text", "Text", "final", "IsFinal"), Map.of()),
            "said", new Adapter(Adapter.Type.SPEECH, Map.of(), Map.of()),
            "bodies", new Adapter(Adapter.Type.GESTURE, Map.of("joints", "0.Joints"), Map.of("side", "right")))));

    private static BridgeSettings settings(String... subscribe) {
        BridgeSettings s = RunningBridge.SETTINGS;
        return new BridgeSettings(s.command(), s.stream(), s.events(), List.of(subscribe), Security.LOOPBACK, 1, 100, 0.1, s.limits());
    }

    private static void publish(ZMQ.Socket publisher, String topic, String json) {
        publisher.sendMore(topic);
        publisher.send(json.replace('\'', '"').getBytes(StandardCharsets.UTF_8));
    }

    @Test
    void topicsBecomeSpeechAndGestures() throws InterruptedException {
        try (ZContext context = new ZContext()) {
            ZMQ.Socket publisher = context.createSocket(SocketType.XPUB);
            publisher.setReceiveTimeOut(20_000);
            publisher.bind("tcp://127.0.0.1:*");
            String address = publisher.getLastEndpoint();
            try (RunningBridge bridge = RunningBridge.of(DOMAIN, new Confirm(), settings(address), Recovery.none(DOMAIN, 1, 2), null)) {
                for (int topics = 0; topics < 3; topics++) {
                    assertTrue(publisher.recv() != null, "it subscribes to each topic");
                }
                bridge.event("heartbeat");
                bridge.ask("{'v':1,'type':'begin'}");
                bridge.event("belief");
                publish(publisher, "speech", "{'originatingTime':'" + Instant.now() + "','message':{'Text':'the red one','IsFinal':true,"
                        + "'Confidence':0.7}}");
                JsonNode heard = bridge.event("belief");
                assertEquals("speech the red one", heard.get("source").asText() + " " + heard.get("heard").get(0).asText());
                publish(publisher, "bodies", "{'message':[{'Joints':{'ShoulderRight':[0.15,1.4,0.35],'HandRight':[0.29,0.9,0.09],"
                        + "'Head':'?'}}]}");
                assertEquals("bodies gesture", bridge.event("belief").get("source").asText() + " gesture");
                publish(publisher, "said", "{'originatingTime':638994816000000000,'message':'red'}");
                assertEquals("stale", bridge.event("error").get("code").asText(), ".NET ticks of the past");
                publish(publisher, "said", "'red'");
                assertEquals("red", bridge.event("belief").get("heard").get(0).asText());
                publish(publisher, "speech", "{'originatingTime':'yesterday','message':{}}");
                JsonNode error = bridge.event("error");
                assertEquals("bad_field originatingTime speech", error.get("code").asText() + " " + error.get("path").asText() + " "
                        + error.get("source").asText());
                publish(publisher, "speech", "{'message':{'Words':'red'}}");
                assertEquals("missing_field", bridge.event("error").get("code").asText());
                publish(publisher, "speech", "red");
                assertEquals("not_json", bridge.event("error").get("code").asText());
                publisher.send("speech");
                assertEquals("not_json", bridge.event("error").get("code").asText());
                assertEquals(4, bridge.ask("{'v':1,'type':'state'}").get("belief_version").asInt());
            }
        }
    }

    @Test
    void feedsNeedAnAdapter() {
        for (String option : List.of("tcp://127.0.0.1:5800,nothing", "tcp://127.0.0.1:*", "tcp://*:5800", "127.0.0.1:5800")) {
            assertTrue(assertThrows(BridgeException.class, () -> new Bridge(DOMAIN, new Confirm(), settings(option)).close())
                    .getMessage().startsWith("--subscribe: "), option);
        }
        HandoverDomain none = DomainFiles.load("table-line-6");
        assertThrows(BridgeException.class, () -> new Bridge(none, new Confirm(), settings("tcp://127.0.0.1:5800")).close());
    }
}
