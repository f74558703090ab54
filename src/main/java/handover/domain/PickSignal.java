package handover.domain;

/** What the human sees or the robot senses of a pick in this step (MODEL section 4). */
public enum PickSignal {
    NONE,
    MOVING,
    ACCEPTED,
    REJECTED
}
