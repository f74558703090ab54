package handover.simulation;

/** How the robot's time is spent on observing, thinking and acting. */
public enum Agent {
    /** Acts and observes; then thinks, and notices what happens meanwhile only afterwards; then acts. */
    SEQUENTIAL,
    /** Observes all the time; plans the next act while the last one still runs, and anew when the belief moved. */
    CONCURRENT
}
