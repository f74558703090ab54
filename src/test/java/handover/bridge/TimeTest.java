package handover.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.fasterxml.jackson.databind.JsonNode;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Messages that come late, from the future, or by clocks that jump. */
class TimeTest {
    private static final String DOMAIN = "bowls-and-spoons";
    private static final String STATE = "{'v':1,'type':'state'}";
    private static final double ROUNDING = 1e-9;

    @TempDir
    Path folder;

    /** A "yes" that was said to the question counts for the question, though the robot points already when it is heard. */
    @Test
    void whatComesLateIsWeighedAgainstTheActOfItsTime() throws Exception {
        try (BridgeProcess bridge = start("60"); WireClient wire = new WireClient(bridge)) {
            double t = System.currentTimeMillis() / 1e3;
            String begin = message("begin", t - 5, "");
            String ask = message("acted", t - 4, "'act':'ASK','objects':['silver_spoon'],'status':'started'");
            String asked = message("acted", t - 2, "'act':'ASK','objects':['silver_spoon'],'status':'completed'");
            String point = message("acted", t - 1, "'act':'POINT','objects':['metal_bowl'],'status':'started'");
            String yes = message("speech", t - 3, "'text':'yes'");
            List<String> inOrder = List.of(begin, ask, yes, asked, point);
            for (String m : List.of(begin, ask, asked, point, yes)) {
                wire.must(m);
            }
            assertClose(BridgeProcess.JSON.readTree(oracle(inOrder).split(" ")[0]), wire.must(STATE));
        }
    }

    @Test
    void whatIsTooOldIsRefusedAndWhatIsOfTomorrowIsNow() throws Exception {
        try (BridgeProcess bridge = start("2"); WireClient wire = new WireClient(bridge)) {
            double t = System.currentTimeMillis() / 1e3;
            List<String> good = new ArrayList<>();
            good.add(message("begin", null, ""));
            good.add(message("acted", null, "'act':'POINT','objects':['metal_bowl'],'status':'started'"));
            good.forEach(m -> must(wire, m));
            for (int k = 1; k <= 20; k++) {
                double hours = 3600.0 * k;
                JsonNode old = wire.ask(message("speech", t - hours, "'text':'large black bowl'"));
                assertEquals("stale", old.path("code").asText(), old.toString());
                String ahead = message("speech", t + hours, "'text':'small'");
                must(wire, ahead);
                good.add(ahead);
            }
            assertEquals(oracle(good), GoodMessages.belief(wire.must(STATE)));
        }
    }

    private static void must(WireClient wire, String message) {
        try {
            wire.must(message);
        } catch (java.io.IOException e) {
            throw new java.io.UncheckedIOException(e);
        }
    }

    private static String oracle(List<String> messages) throws Exception {
        return GoodMessages.state(DOMAIN, messages.stream().map(m -> m.replace('\'', '"')).toList());
    }

    private static void assertClose(JsonNode expected, JsonNode state) {
        for (String name : List.of("metal_bowl", "color_bowl", "plastic_spoon", "silver_spoon")) {
            assertEquals(expected.get(name).asDouble(), state.get("belief").get(name).asDouble(), ROUNDING, state.toString());
        }
    }

    private BridgeProcess start(String maxAge) throws Exception {
        return BridgeProcess.start(folder, DOMAIN, "--solver", "confirm", "--max-age", maxAge);
    }

    private static String message(String type, Double t, String fields) {
        return "{'v':1,'type':'" + type + "'" + (t == null ? "" : String.format(Locale.ROOT, ",'t':%.3f", t))
                + (fields.isEmpty() ? "" : "," + fields) + "}";
    }
}
