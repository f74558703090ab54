package handover.solver;

/** Until when to think. Implementations are thread safe and cheap; whoever makes one owns the clock. */
@FunctionalInterface
public interface Deadline {
    /** Thinking may take as long as the solver's own limits say. */
    Deadline NONE = () -> false;

    /** Whether the time is up; once true, always true. */
    boolean passed();
}
