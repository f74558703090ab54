package handover.domain;

import burlap.mdp.core.action.Action;
import java.util.List;

/**
 * Something that the robot can do, for instance ASK(red_ball). Immutable; equal if verb and objects are equal.
 *
 * @param verb the type of act in upper case
 * @param objects names of the objects that it is about, in table order
 */
public record Act(String verb, List<String> objects) implements Action {
    public static final Act WAIT = new Act("WAIT", List.of());

    public Act {
        objects = List.copyOf(objects);
    }

    /** An act about the named objects. */
    public static Act of(String verb, String... objects) {
        return new Act(verb, List.of(objects));
    }

    @Override
    public String actionName() {
        return verb;
    }

    @Override
    public Act copy() {
        return this;
    }

    /** {@code WAIT}, {@code ASK(red_ball,blue_ball)}. */
    @Override
    public String toString() {
        return objects.isEmpty() ? verb : verb + "(" + String.join(",", objects) + ")";
    }
}
