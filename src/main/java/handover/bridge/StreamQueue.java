package handover.bridge;

import handover.io.WireMessage;
import java.util.ArrayDeque;
import java.util.Deque;

/**
 * Messages of the stream that wait to be applied, in the order in which they came. When it is full, the oldest gesture or
 * unfinal speech gives way; what may not be lost is refused. Used by one thread.
 */
final class StreamQueue {
    private static final long MOST_BYTES = 64L << 20;

    private final int capacity;
    private final Deque<Waiting> kept = new ArrayDeque<>();
    private final Deque<Waiting> sheddable = new ArrayDeque<>();
    private long next;
    private long bytes;
    private long shed;

    /**
     * A message that waits.
     *
     * @param number in the order of arrival
     * @param received its bytes, and when they came
     */
    record Waiting(long number, WireMessage message, Inbox.Received received) {
        private int length() {
            return received.body().length;
        }
    }

    StreamQueue(int capacity) {
        this.capacity = capacity;
    }

    /** Adds a message; false if there is no room for it even without what may be lost. */
    boolean add(WireMessage message, Inbox.Received received) {
        while (size() >= capacity || size() > 0 && bytes + received.body().length > MOST_BYTES) {
            Waiting oldest = sheddable.pollFirst();
            if (oldest == null) {
                boolean lost = mayBeLost(message);
                shed += lost ? 1 : 0;
                return lost;
            }
            bytes -= oldest.length();
            shed++;
        }
        (mayBeLost(message) ? sheddable : kept).addLast(new Waiting(next++, message, received));
        bytes += received.body().length;
        return true;
    }

    private static boolean mayBeLost(WireMessage message) {
        return message instanceof WireMessage.Pointed || message instanceof WireMessage.Heard heard && !heard.complete();
    }

    /** Takes the oldest message; null if there is none. */
    Waiting poll() {
        Waiting a = kept.peekFirst();
        Waiting b = sheddable.peekFirst();
        Waiting first = a == null || b != null && b.number < a.number ? sheddable.pollFirst() : kept.pollFirst();
        bytes -= first == null ? 0 : first.length();
        return first;
    }

    int size() {
        return kept.size() + sheddable.size();
    }

    /** How many of them may not be lost. */
    int owed() {
        return kept.size();
    }

    long bytes() {
        return bytes;
    }

    /** How many messages gave way since the beginning. */
    long shed() {
        return shed;
    }
}
