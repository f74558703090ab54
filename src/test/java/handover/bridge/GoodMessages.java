package handover.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.fasterxml.jackson.databind.JsonNode;
import handover.cli.Main;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;

/** What the good messages alone come to: the oracle for a bridge that also got bad ones. */
final class GoodMessages {
    private GoodMessages() {}

    /** Both beliefs and the open reference after these messages, by the command {@code infer}, digit for digit. */
    static String state(String domain, List<String> messages) throws IOException {
        String input = String.join("\n", messages) + "\n{\"v\":1,\"type\":\"state\"}\n";
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        int code = Main.run(new String[] {"infer", domain}, new ByteArrayInputStream(input.getBytes(StandardCharsets.UTF_8)),
                new PrintStream(out, true, StandardCharsets.UTF_8), new PrintStream(err, true, StandardCharsets.UTF_8));
        assertEquals(0, code, err.toString(StandardCharsets.UTF_8));
        List<String> replies = out.toString(StandardCharsets.UTF_8).lines().toList();
        assertEquals(messages.size() + 1, replies.size());
        for (String reply : replies) {
            assertEquals(false, reply.startsWith("{\"v\":1,\"type\":\"error\""), reply);
        }
        return belief(BridgeProcess.JSON.readTree(replies.get(replies.size() - 1)));
    }

    /** The same of a reply or event of the bridge. */
    static String belief(JsonNode tree) {
        return tree.get("belief") + " " + tree.get("human_belief") + " " + tree.get("open_reference") + " " + tree.get("done");
    }
}
