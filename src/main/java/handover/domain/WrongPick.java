package handover.domain;

/** What becomes of an object that was handed over although another one was wanted (MODEL section 5). */
public enum WrongPick {
    /** It goes back; it is known not to be wanted. */
    RETURNED,
    /** It leaves the table. */
    REMOVED,
    /** The episode ends. */
    TERMINAL
}
