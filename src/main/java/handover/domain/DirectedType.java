package handover.domain;

import handover.math.Simplex;
import handover.math.Vector3;
import java.util.List;

/** POINT(x) and LOOK(x): a direction that people read with an angular error (MODEL 3.1, 3.3). */
public final class DirectedType extends ActType {
    public static final String POINT = "POINT";
    public static final String LOOK = "LOOK";

    private final Vector3 origin;
    private final double sigma;

    /**
     * @param origin where the robot points from, metres
     * @param sigma standard deviation of the direction as people see it, radians
     */
    public DirectedType(String verb, ActParameters parameters, Vector3 origin, double sigma) {
        super(verb, parameters);
        this.origin = origin;
        this.sigma = sigma;
    }

    @Override
    public List<Act> acts(List<TableObject> present) {
        return present.stream().map(o -> Act.of(verb(), o.name())).toList();
    }

    /** G_sigma(x, i) for each i. */
    @Override
    public double[] weights(Act act, List<TableObject> present) {
        Vector3 towards = present.get(indexOf(act.objects().get(0), present)).position().minus(origin);
        double[] g = new double[present.size()];
        for (int i = 0; i < g.length; i++) {
            double theta = towards.angleTo(present.get(i).position().minus(origin));
            g[i] = Math.exp(-theta * theta / (2 * sigma * sigma));
        }
        return g;
    }

    @Override
    public double[] match(Act act, List<TableObject> present) {
        double[] g = weights(act, present);
        Simplex.normalise(g, g.length);
        return g;
    }
}
