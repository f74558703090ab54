package handover.belief;

import handover.domain.ActEffect;
import handover.domain.ActModel;
import handover.domain.HandoverDomain;
import handover.domain.Percept;
import handover.domain.Scene;
import handover.domain.Task;
import handover.math.Simplex;
import handover.theory.Clustering;
import handover.theory.Merging;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

/**
 * The joint belief over what is wanted and the human's mind (docs/theory.md, 9), as one list of minds of which nothing is
 * modified. One mind is the base model, and then all of this is the plain filter.
 */
final class Minds {
    /** A further coordinate for each task: minds with different ones are at squared distance 8, beliefs at most at 2. */
    private static final double OTHER_TASK = 4;

    private Minds() {}

    /** Starts an act: the wish may move, and each mind may perceive the act in each way that it can be perceived. */
    static List<Mind> after(List<Mind> minds, Scene scene, ActModel act) {
        HandoverDomain domain = scene.domain();
        List<Percept> percepts = scene.percepts(act);
        List<Mind> next = new ArrayList<>(minds.size() * percepts.size());
        for (Mind m : minds) {
            double[] moved = moved(m.log(), domain.spec().tau(), minds.size() == 1);
            for (Percept percept : percepts) {
                ActEffect seen = m.task().effect(percept.act().index());
                next.add(new Mind(seen.during(), seen, domain.understood(percept.act(), m.human()),
                        scaled(moved, percept.probability())));
            }
        }
        return next;
    }

    private static double[] moved(double[] log, double tau, boolean normalised) {
        double total = tau == 1 || normalised ? 0 : Simplex.logSumExp(log);
        if (tau == 1 || total == Double.NEGATIVE_INFINITY) {
            return log;
        }
        double[] p = LogWeights.exp(shifted(log, -total));
        Simplex.propagate(tau, p, p, p.length);
        return shifted(LogWeights.log(p), total);
    }

    private static double[] scaled(double[] log, double p) {
        return p == 1 ? log : shifted(log, Math.log(p));
    }

    private static double[] shifted(double[] log, double by) {
        return by == 0 ? log : Arrays.stream(log).map(l -> l + by).toArray();
    }

    /** Bayes' rule with one row of log likelihoods per mind; null if what was sensed is impossible. */
    static List<Mind> corrected(List<Mind> minds, double[][] logLikelihood) {
        int n = minds.get(0).log().length;
        double[] all = new double[minds.size() * n];
        for (int m = 0; m < minds.size(); m++) {
            for (int i = 0; i < n; i++) {
                all[m * n + i] = minds.get(m).log()[i] + logLikelihood[m][i];
            }
        }
        return Simplex.normaliseLog(all) ? weighing(minds, all, n) : null;
    }

    private static List<Mind> weighing(List<Mind> minds, double[] all, int n) {
        if (minds.size() == 1) {
            return List.of(minds.get(0).weighing(all));
        }
        List<Mind> next = new ArrayList<>(minds.size());
        for (int m = 0; m < minds.size(); m++) {
            double[] row = Arrays.copyOfRange(all, m * n, (m + 1) * n);
            if (Arrays.stream(row).anyMatch(l -> l > Double.NEGATIVE_INFINITY)) {
                next.add(minds.get(m).weighing(row));
            }
        }
        return next;
    }

    /** log b: what is wanted, whatever the human thinks. */
    static double[] marginal(List<Mind> minds) {
        if (minds.size() == 1) {
            return minds.get(0).log();
        }
        double[] log = new double[minds.get(0).log().length];
        Arrays.setAll(log, i -> Simplex.logSumExp(minds.stream().mapToDouble(m -> m.log()[i]).toArray()));
        return log;
    }

    /** E[beta]. */
    static double[] mean(List<Mind> minds) {
        if (minds.size() == 1) {
            return minds.get(0).human();
        }
        double[] mean = new double[minds.get(0).human().length];
        for (Mind m : minds) {
            double w = m.weight();
            for (int i = 0; i < mean.length; i++) {
                mean[i] += w * m.human()[i];
            }
        }
        Simplex.normalise(mean, mean.length);
        return mean;
    }

    /** Certain that object {@code wanted} is wanted; what was thought impossible leaves the minds as likely as they were. */
    static List<Mind> revealed(List<Mind> minds, int wanted) {
        int n = minds.get(0).log().length;
        boolean possible = minds.stream().anyMatch(m -> m.log()[wanted] > Double.NEGATIVE_INFINITY);
        double[] all = new double[minds.size() * n];
        Arrays.fill(all, Double.NEGATIVE_INFINITY);
        for (int m = 0; m < minds.size(); m++) {
            double[] log = minds.get(m).log();
            all[m * n + wanted] = possible ? log[wanted] : Simplex.logSumExp(log);
        }
        Simplex.normaliseLog(all);
        return weighing(minds, all, n);
    }

    /**
     * The same about another table (see {@link HandoverBelief#on}): what each mind thinks of new objects, it thinks of them as
     * likely as it is.
     *
     * @param before for each object of the table where it was, -1 if it is new
     * @param step of the robot on that table, null if there is none
     */
    static List<Mind> on(List<Mind> minds, Scene other, int[] before, ActEffect step) {
        int n = minds.get(0).log().length;
        boolean same = before.length == n && IntStream.range(0, n).allMatch(i -> before[i] == i);
        double[] kept = new double[minds.size()];
        Arrays.setAll(kept, m -> Simplex.logSumExp(Arrays.stream(before).filter(i -> i >= 0).mapToDouble(i -> minds.get(m).log()[i]).toArray()));
        double[] weight = kept.clone();
        if (!Simplex.normaliseLog(weight)) {
            weight = LogWeights.log(LogWeights.exp(minds.stream().mapToDouble(m -> Simplex.logSumExp(m.log())).toArray()));
        }
        List<Mind> next = new ArrayList<>(minds.size());
        for (int m = 0; m < weight.length; m++) {
            Mind mind = minds.get(m);
            if (weight[m] > Double.NEGATIVE_INFINITY) {
                next.add(new Mind(mind.task().on(other), step == null ? null : mind.step().on(other),
                        same ? mind.human() : LogWeights.exp(LogWeights.carried(LogWeights.log(mind.human()), before)),
                        same ? mind.log() : shifted(LogWeights.carried(mind.log(), before), minds.size() == 1 ? 0 : weight[m])));
            }
        }
        return next;
    }

    /**
     * Minds between which no later act can tell put together, then near ones if there are more than {@code limit}. This
     * changes neither b nor E[beta].
     */
    static List<Mind> merged(List<Mind> minds, int limit) {
        if (minds.size() == 1) {
            return minds;
        }
        List<Task> tasks = minds.stream().map(m -> m.task().settled()).distinct().toList();
        List<Mind> settled = minds.stream().map(m -> m.seeing(tasks.get(tasks.indexOf(m.task().settled())))).toList();
        List<Mind> exact = grouped(settled, Merging.groups(places(settled, tasks)));
        if (exact.size() <= limit) {
            return exact;
        }
        double[] weights = exact.stream().mapToDouble(Mind::weight).toArray();
        return grouped(exact, Clustering.groups(weights, places(exact, tasks), limit));
    }

    /** Beliefs with further coordinates that keep minds with different tasks apart. */
    private static List<double[]> places(List<Mind> minds, List<Task> tasks) {
        return minds.stream().map(m -> {
            int n = m.human().length;
            double[] place = Arrays.copyOf(m.human(), n + tasks.size());
            place[n + tasks.indexOf(m.task())] = OTHER_TASK;
            return place;
        }).toList();
    }

    /** Probabilities added up and beliefs averaged within each group; what is open is what it is for the likeliest. */
    private static List<Mind> grouped(List<Mind> minds, int[] group) {
        List<List<Mind>> members = new ArrayList<>();
        for (int k = 0; k < group.length; k++) {
            while (members.size() <= group[k]) {
                members.add(new ArrayList<>());
            }
            members.get(group[k]).add(minds.get(k));
        }
        return members.stream().filter(g -> !g.isEmpty()).map(Minds::together).toList();
    }

    private static Mind together(List<Mind> group) {
        Mind likeliest = group.get(0);
        for (Mind m : group) {
            likeliest = m.weight() > likeliest.weight() ? m : likeliest;
        }
        boolean weightless = likeliest.weight() == 0;
        return group.size() == 1 ? likeliest
                : new Mind(likeliest.task(), likeliest.step(), weightless ? likeliest.human() : mean(group), marginal(group));
    }
}
