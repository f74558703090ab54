package handover.domain;

import java.util.ArrayList;
import java.util.List;

/**
 * What the human may take an act for. Immutable.
 *
 * @param act that they perceive
 * @param probability P(a~ | a), above 0
 */
public record Percept(ActModel act, double probability) {
    /** Acts that are alike to this relative precision are equally easily confused. */
    private static final double TIE = 1e-9;

    /** Surely the act itself. */
    static List<Percept> exact(ActModel act) {
        return List.of(new Percept(act, 1));
    }

    /**
     * Itself, or, misread, one of the acts of its type that are most like it, or, missed, a WAIT; a misread act that is like
     * no other is perceived as it is. Possible ones only.
     */
    static List<Percept> of(ActModel act, List<ActModel> offered, PerceptionParameters perception) {
        List<ActModel> alike = mostAlike(act, offered);
        double misread = alike.isEmpty() ? 0 : perception.misread();
        List<Percept> all = new ArrayList<>();
        add(act, 1 - perception.missed() - misread, all);
        alike.forEach(m -> add(m, misread / alike.size(), all));
        offered.stream().filter(m -> m.act().equals(Act.WAIT)).forEach(m -> add(m, perception.missed(), all));
        return List.copyOf(all);
    }

    private static void add(ActModel act, double p, List<Percept> all) {
        if (p > 0) {
            all.add(new Percept(act, p));
        }
    }

    /** The others of the type with the largest sum_i lambda(a | i) lambda(a~ | i): for a direction, the nearest. */
    private static List<ActModel> mostAlike(ActModel act, List<ActModel> offered) {
        List<ActModel> best = new ArrayList<>();
        double most = 0;
        for (ActModel other : offered) {
            if (other == act || other.type() != act.type()) {
                continue;
            }
            double likeness = likeness(act.lambda(), other.lambda());
            if (likeness > most * (1 + TIE)) {
                best.clear();
                most = likeness;
            }
            if (likeness > 0 && likeness >= most * (1 - TIE)) {
                best.add(other);
            }
        }
        return best;
    }

    private static double likeness(double[] lambda, double[] other) {
        double sum = 0;
        for (int i = 0; i < lambda.length; i++) {
            sum += lambda[i] * other[i];
        }
        return sum;
    }
}
