package handover.bridge;

import java.util.ArrayDeque;
import java.util.Deque;

/**
 * Messages of the stream as they came off the socket, nobody having looked at them: taking them is so cheap that what came
 * before a command is nearly always taken before it. Used by one thread.
 */
final class Inbox {
    private static final int MOST = 5000;
    private static final long MOST_BYTES = 64L << 20;

    private final Deque<Received> waiting = new ArrayDeque<>();
    private long bytes;

    /**
     * A message that nobody has looked at.
     *
     * @param body its bytes
     * @param nanos when it was taken from the socket
     * @param at the same in Unix seconds
     */
    record Received(byte[] body, long nanos, double at) {}

    /** Whether more should be taken. */
    boolean hasRoom() {
        return waiting.size() < MOST && bytes < MOST_BYTES;
    }

    void add(Received message) {
        waiting.addLast(message);
        bytes += message.body.length;
    }

    /** Takes the oldest message; null if there is none. */
    Received poll() {
        Received first = waiting.pollFirst();
        bytes -= first == null ? 0 : first.body.length;
        return first;
    }

    int size() {
        return waiting.size();
    }

    long bytes() {
        return bytes;
    }
}
