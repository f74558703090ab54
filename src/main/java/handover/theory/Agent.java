package handover.theory;

/**
 * Whose choice a level is about, as a type that is never instantiated. Everything marked {@code <Robot>} is about the
 * object that the robot will hand over (its choice i, the human's belief beta, the robot's nested belief B); everything
 * marked {@code <Human>} is about the object that the human wants (iota, the robot's belief b, the human's nested
 * belief). So the likelihood of a human's act cannot correct a belief about the robot: it does not compile.
 *
 * @param <Self> this agent
 * @param <Other> the one it talks to
 */
public sealed interface Agent<Self extends Agent<Self, Other>, Other extends Agent<Other, Self>> {
    /** Acts at whole times t. */
    final class Robot implements Agent<Robot, Human> {
        private Robot() {}
    }

    /** Acts at half times tau = t + 1/2. */
    final class Human implements Agent<Human, Robot> {
        private Human() {}
    }
}
