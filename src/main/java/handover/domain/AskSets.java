package handover.domain;

/** Which sets of objects the robot asks about (MODEL section 3). */
public enum AskSets {
    /** One object at a time, said with its label. */
    SINGLETONS,
    /** Also all objects that share a word, said with that word. */
    ATTRIBUTES
}
