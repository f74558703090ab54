package handover.io;

import java.util.Locale;

/** What can be wrong with a message (docs/bridge.md). */
public enum WireCode {
    NOT_JSON, TOO_LARGE, BAD_VERSION, BAD_TYPE, MISSING_FIELD, BAD_FIELD, UNKNOWN_OBJECT, UNKNOWN_FRAME, STALE, NO_EPISODE,
    ILLEGAL_ACT, BUSY, INTERNAL;

    /** As in a message: {@code bad_field}. */
    public String key() {
        return name().toLowerCase(Locale.ROOT);
    }
}
