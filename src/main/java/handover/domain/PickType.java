package handover.domain;

import handover.math.Simplex;
import java.util.Arrays;
import java.util.List;

/** PICK(x): hand over object x, or reach a little further towards it. */
public final class PickType extends ActType {
    public static final String VERB = "PICK";

    private final double error;

    /** @param error eps_pick, in [0, 1] */
    public PickType(ActParameters parameters, double error) {
        super(VERB, parameters);
        this.error = error;
    }

    @Override
    public List<Act> acts(List<TableObject> present) {
        return present.stream().map(o -> Act.of(VERB, o.name())).toList();
    }

    @Override
    public double[] weights(Act act, List<TableObject> present) {
        int n = present.size();
        double[] w = new double[n];
        Arrays.fill(w, n == 1 ? 1 : error / (n - 1));
        if (n > 1) {
            w[target(act, present)] = 1 - error;
        }
        return w;
    }

    @Override
    public double[] match(Act act, List<TableObject> present) {
        return Simplex.vertex(present.size(), target(act, present));
    }

    @Override
    public int target(Act act, List<TableObject> present) {
        return indexOf(act.objects().get(0), present);
    }
}
