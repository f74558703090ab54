package handover.solver;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.ActModel;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.random.RandomGenerator;

/**
 * Decides as was decided at the nearest stored beliefs, the report's earlier solver: the values of each act at up to k of them
 * within a radius are averaged with weights 1/distance and the best is done. Where nothing stored holds (objects were
 * moved, added or removed; a task never met) or nothing is near, another policy decides and the decision says so. What a
 * decision allocates does not depend on the size of the table. Thread safe.
 */
public final class NearestPolicy implements Policy {
    /** Distance at which two stored beliefs are told apart; float coordinates resolve about 1e-7. */
    private static final double RESOLUTION = 1e-6;

    private final PolicyTable table;
    private final BeliefSpace space;
    private final int k;
    private final double radius;
    private final Policy fallback;
    private final String fallbackName;

    /**
     * @param k how many neighbours vote, at least 1
     * @param radius farthest distance of a neighbour, under the table's metric; may be infinite
     * @param fallbackName what notes call the policy that decides where the table does not
     */
    public NearestPolicy(PolicyTable table, int k, double radius, Policy fallback, String fallbackName) {
        this.table = table;
        this.space = new BeliefSpace(table.metric());
        this.k = k;
        this.radius = radius;
        this.fallback = fallback;
        this.fallbackName = fallbackName;
    }

    @Override
    public Decision decide(HandoverBelief belief, Deadline deadline, RandomGenerator random) {
        BeliefSpace.Located at = space.locate(belief.task());
        PolicyPart part = table.part(at.part().depends());
        if (part == null || part.acts() != belief.scene().acts().size()) {
            return fallback(belief, deadline, random, "nothing is stored for these objects, this question and this reach");
        }
        Neighbours nearest = nearest(part, belief, at.images());
        if (nearest.size() == 0) {
            return fallback(belief, deadline, random, "no stored belief within " + radius);
        }
        return decision(part, nearest, belief.scene().acts(), at.images());
    }

    private Decision fallback(HandoverBelief belief, Deadline deadline, RandomGenerator random, String why) {
        return fallback.decide(belief, deadline, random).noted("fallback to " + fallbackName + ": " + why);
    }

    private Neighbours nearest(PolicyPart part, HandoverBelief belief, List<Symmetry> images) {
        Neighbours nearest = new Neighbours(k, part.ordinals(), (float) (radius * radius));
        float[] query = new float[part.part().dimensions()];
        for (int s = 0; s < images.size(); s++) {
            table.metric().coordinates(belief, images.get(s).objects(), query);
            nearest.under(s);
            part.tree().search(query, nearest);
        }
        return nearest;
    }

    private static Decision decision(PolicyPart part, Neighbours nearest, List<ActModel> acts, List<Symmetry> images) {
        Map<Act, Double> values = new LinkedHashMap<>();
        ActModel best = null;
        double most = Double.NEGATIVE_INFINITY;
        for (ActModel m : acts) {
            double value = value(part, nearest, m.index(), images);
            if (!Double.isNaN(value)) {
                values.put(m.act(), value);
                if (value > most) {
                    most = value;
                    best = m;
                }
            }
        }
        if (best == null || nearest.size() == 1) {
            best = chosen(part, nearest, acts, images);
        }
        return new Decision(best.act(), values, 0, nearest.seen(), true);
    }

    /** The weighted mean of a value; NaN if some neighbour has none. */
    private static double value(PolicyPart part, Neighbours nearest, int act, List<Symmetry> images) {
        double sum = 0;
        double weights = 0;
        for (int j = 0; j < nearest.size(); j++) {
            double w = weight(nearest, j);
            int stored = images.get(nearest.image(j)).acts()[act];
            sum += w * part.values()[nearest.row(j) * part.acts() + stored];
            weights += w;
        }
        return sum / weights;
    }

    /** The act with the most weight among those that the neighbours chose. */
    private static ActModel chosen(PolicyPart part, Neighbours nearest, List<ActModel> acts, List<Symmetry> images) {
        ActModel best = null;
        double most = -1;
        for (ActModel m : acts) {
            double weight = 0;
            for (int j = 0; j < nearest.size(); j++) {
                boolean same = part.choices()[nearest.row(j)] == images.get(nearest.image(j)).acts()[m.index()];
                weight += same ? weight(nearest, j) : 0;
            }
            if (weight > most) {
                most = weight;
                best = m;
            }
        }
        return best;
    }

    private static double weight(Neighbours nearest, int j) {
        return 1 / (nearest.distance(j) + RESOLUTION);
    }
}
