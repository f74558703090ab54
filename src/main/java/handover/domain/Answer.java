package handover.domain;

/** What the human says to the open reference or to an advancing pick. */
public enum Answer {
    NONE,
    YES,
    NO
}
