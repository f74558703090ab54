package handover.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.io.Messages;
import handover.io.WireMessage;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;

/** What gives way, in which order, and that nothing is lost uncounted. */
class StreamQueueTest {
    private static final WireMessage FINAL = message("{\"v\":1,\"type\":\"speech\",\"text\":\"red\"}");
    private static final WireMessage UNFINAL = message("{\"v\":1,\"type\":\"speech\",\"text\":\"red\",\"final\":false}");
    private static final WireMessage GESTURE = message("{\"v\":1,\"type\":\"gesture\",\"hand\":[0,1,0],\"shoulder\":[0,0,0]}");
    private static final WireMessage BEGIN = message("{\"v\":1,\"type\":\"begin\"}");

    private static WireMessage message(String json) {
        return Messages.decode(json.getBytes(StandardCharsets.UTF_8));
    }

    private static Inbox.Received received(byte[] body, long number) {
        return new Inbox.Received(body, number, 0);
    }

    private record Sent(int number, WireMessage message) {}

    /** Against the slow way: one list, searched from its beginning for what may give way. */
    @Property(tries = 300)
    void isAListThatShedsTheOldest(@ForAll List<Byte> script) {
        StreamQueue queue = new StreamQueue(5);
        List<Sent> list = new ArrayList<>();
        long shed = 0;
        int number = 0;
        for (byte b : script) {
            if (b % 5 == 0) {
                StreamQueue.Waiting got = queue.poll();
                assertEquals(list.isEmpty() ? -1 : list.remove(0).number, got == null ? -1 : got.received().nanos());
                continue;
            }
            WireMessage message = List.of(FINAL, UNFINAL, GESTURE, BEGIN).get(Math.floorMod(b, 4));
            boolean loseable = message == UNFINAL || message == GESTURE;
            boolean accepted = queue.add(message, received(new byte[1], number));
            int victim = -1;
            for (int k = 0; k < list.size() && victim < 0; k++) {
                victim = list.get(k).message == UNFINAL || list.get(k).message == GESTURE ? k : -1;
            }
            if (list.size() < 5) {
                list.add(new Sent(number, message));
            } else if (victim >= 0) {
                list.remove(victim);
                list.add(new Sent(number, message));
                shed++;
            } else {
                assertEquals(loseable, accepted, "what may not be lost is refused, not dropped");
                shed += loseable ? 1 : 0;
            }
            number++;
            assertEquals(list.size(), queue.size());
            assertEquals(list.size(), queue.bytes());
            assertEquals(shed, queue.shed());
        }
    }

    @Test
    void bytesAreLimitedToo() {
        StreamQueue queue = new StreamQueue(1000);
        byte[] large = new byte[1 << 20];
        for (int k = 0; k < 64; k++) {
            assertTrue(queue.add(FINAL, received(large, k)));
        }
        assertFalse(queue.add(FINAL, received(large, 64)));
        assertEquals(64, queue.size());
        queue.poll();
        assertTrue(queue.add(GESTURE, received(large, 65)));
        assertTrue(queue.add(BEGIN, received(new byte[10], 66)));
        assertEquals(1, queue.shed());
    }
}
