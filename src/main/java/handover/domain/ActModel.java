package handover.domain;

/**
 * An act on a given {@link Scene} with all that follows from it: what it tells the human, what they take it to refer to.
 * Immutable, thread safe; the arrays have one entry per object and must not be modified.
 */
public final class ActModel {
    private final int index;
    private final Act act;
    private final ActType type;
    private final double[] lambda;
    private final double[] match;
    private final int target;
    private final String say;

    ActModel(int index, Act act, ActType type, double[] lambda, double[] match, int target, String say) {
        this.index = index;
        this.act = act;
        this.type = type;
        this.lambda = lambda;
        this.match = match;
        this.target = target;
        this.say = say;
    }

    /** Position in {@link Scene#acts()}. */
    public int index() {
        return index;
    }

    public Act act() {
        return act;
    }

    public ActType type() {
        return type;
    }

    /** lambda(act | i) for each object i. */
    public double[] lambda() {
        return lambda;
    }

    /** M_act(i) for each object i; null if the act refers to nothing. */
    public double[] match() {
        return match;
    }

    /** The object that the act reaches for, -1 if none. */
    public int target() {
        return target;
    }

    /** The words said with the act, empty if none. */
    public String say() {
        return say;
    }

    public boolean isPick() {
        return target >= 0;
    }

    /** Whether the act becomes the open reference: it refers to something and is not a pick. */
    public boolean isCommunicative() {
        return match != null && !isPick();
    }

    @Override
    public String toString() {
        return act.toString();
    }
}
