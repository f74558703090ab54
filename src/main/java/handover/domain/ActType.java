package handover.domain;

import burlap.mdp.core.action.Action;
import burlap.mdp.core.action.ActionType;
import burlap.mdp.core.state.State;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/**
 * One type of act: which acts of it the robot has, what they tell the human and what the human takes them to refer to.
 * A variant adds a type of act by adding a subclass to {@link HandoverDomain#actTypes()}. Implementations are immutable.
 */
public abstract class ActType implements ActionType {
    private final String verb;
    private final ActParameters parameters;

    /**
     * @param verb upper case, unique in the domain
     * @param parameters price, duration and reply rates
     */
    protected ActType(String verb, ActParameters parameters) {
        this.verb = verb;
        this.parameters = parameters;
    }

    public final String verb() {
        return verb;
    }

    public final ActParameters parameters() {
        return parameters;
    }

    /** All acts of this type with these objects on the table, in a fixed order. */
    public abstract List<Act> acts(List<TableObject> present);

    /**
     * What the act tells the human: weights proportional to lambda(act | i) of MODEL 3.1 up to the normalisation over the
     * acts of this type, one for each object present. Default: the act tells nothing.
     */
    public double[] weights(Act act, List<TableObject> present) {
        double[] ones = new double[present.size()];
        Arrays.fill(ones, 1);
        return ones;
    }

    /**
     * M_a of MODEL 3.3: for each object present, the probability that the human understands the act as "do you mean
     * this?"; null (default) if the act refers to nothing, so that a question before it stays open.
     */
    public double[] match(Act act, List<TableObject> present) {
        return null;
    }

    /** What the robot says with the act; empty (default) if nothing. */
    public String say(Act act, List<TableObject> present) {
        return "";
    }

    /** The object that the act reaches for, -1 (default) if none. */
    public int target(Act act, List<TableObject> present) {
        return -1;
    }

    @Override
    public final String typeName() {
        return verb;
    }

    /** Reads the objects of an act of this type from a string of names separated by commas. */
    @Override
    public final Action associatedAction(String objects) {
        String names = objects == null ? "" : objects.trim();
        return names.isEmpty() ? Act.of(verb) : Act.of(verb, names.split("\\s*,\\s*"));
    }

    /** The legal acts of this type in a {@link HandoverState}, or in any belief over such states. */
    @Override
    public final List<Action> allApplicableActions(State s) {
        Task task = HandoverState.taskOf(s);
        return task.legalActs().stream().filter(m -> m.type() == this || m.type().verb.equals(verb))
                .map(m -> (Action) m.act()).toList();
    }

    /** The key of this type's parameters in a domain file. */
    static String key(String verb) {
        return verb.toLowerCase(Locale.ROOT);
    }

    /** Position of an object in a list, -1 if it is not there. */
    protected static int indexOf(String name, List<TableObject> present) {
        for (int i = 0; i < present.size(); i++) {
            if (present.get(i).name().equals(name)) {
                return i;
            }
        }
        return -1;
    }
}
