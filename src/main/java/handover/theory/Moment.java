package handover.theory;

/**
 * A moment at which {@code Self} acts: the robot at whole times t, the human half a step later at tau = t + 1/2. Which of
 * the two it is, is part of the type; {@link #next()} changes sides. Immutable.
 *
 * @param halfSteps time in half steps since the first act of the robot; even for the robot, odd for the human
 */
public record Moment<Self extends Agent<Self, Other>, Other extends Agent<Other, Self>>(int halfSteps) {
    /** t = {@code t}, the robot's turn. */
    public static Moment<Agent.Robot, Agent.Human> robot(int t) {
        return new Moment<>(2 * t);
    }

    /** tau = {@code t} + 1/2, the human's turn. */
    public static Moment<Agent.Human, Agent.Robot> human(int t) {
        return new Moment<>(2 * t + 1);
    }

    /** Half a step later, the other's turn. */
    public Moment<Other, Self> next() {
        return new Moment<>(halfSteps + 1);
    }

    /** {@code 3} or {@code 3.5}, in steps. */
    @Override
    public String toString() {
        return halfSteps / 2 + (halfSteps % 2 == 0 ? "" : ".5");
    }
}
