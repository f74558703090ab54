package handover.theory;

import handover.math.Simplex;
import handover.theory.Agent.Robot;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.random.RandomGenerator;

/**
 * What each approximation of B costs in accuracy, against particles, over random dialogues.
 * Immutable, thread safe; arrays and lists must not be modified.
 *
 * @param settings of the dialogues
 * @param deviations one list per method, one entry per dialogue, in the order of the dialogues
 */
public record ProjectionStudy(DialogueSettings settings, Map<Method, List<Deviation>> deviations) {
    /** What is compared with the reference. */
    public enum Method {
        /** A second, independent run of the reference: the accuracy of the comparison itself. */
        PARTICLES,
        /** Near beliefs merged. */
        CLUSTERS,
        /** One Dirichlet with the right mean and E ||beta||^2 after each act. */
        DIRICHLET,
        /** One Dirichlet with the right E[log beta] after each act. */
        DIRICHLET_LOG,
        /** alpha_j += ... */
        COUNTING
    }

    /**
     * Runs the comparison; the same generator state gives the same result.
     *
     * @param dialogues how many
     * @param particles limit of the reference
     * @param clusters limit of {@link Method#CLUSTERS}
     * @param random advanced
     */
    public static ProjectionStudy run(DialogueSettings settings, int dialogues, int particles, int clusters,
            RandomGenerator random) {
        Map<Method, List<Deviation>> all = new EnumMap<>(Method.class);
        for (int k = 0; k < dialogues; k++) {
            RandomGenerator own = new SplittableRandom(random.nextLong());
            Dialogue dialogue = Dialogue.random(settings, own);
            Particles<Robot> reference = reference(settings, particles, own);
            Nested<Robot> right = dialogue.follow(reference);
            for (Method method : Method.values()) {
                Nested<Robot> b = switch (method) {
                    case PARTICLES -> dialogue.follow(reference(settings, particles, own));
                    case CLUSTERS -> dialogue.follow(new Clusters<>(reference.atoms(), clusters));
                    case DIRICHLET -> dialogue.follow(start(settings, Projection.MOMENTS));
                    case DIRICHLET_LOG -> dialogue.follow(start(settings, Projection.LOG_MOMENTS));
                    case COUNTING -> counted(dialogue);
                };
                all.computeIfAbsent(method, m -> new ArrayList<>()).add(Deviation.between(b, right, dialogue.chosen()));
            }
        }
        return new ProjectionStudy(settings, all);
    }

    private static DirichletBelief<Robot> start(DialogueSettings settings, Projection projection) {
        return new DirichletBelief<>(Simplex.uniform(settings.objects()), settings.concentration(), projection);
    }

    private static Particles<Robot> reference(DialogueSettings settings, int limit, RandomGenerator random) {
        return settings.concentration() == Double.POSITIVE_INFINITY
                ? Particles.certain(Categorical.uniform(settings.objects()), limit, random)
                : Particles.of(start(settings, Projection.MOMENTS), limit, random);
    }

    private static DirichletBelief<Robot> counted(Dialogue dialogue) {
        DirichletBelief<Robot> counts = Counting.start(dialogue.transition().size());
        for (Perception<Robot> act : dialogue.acts()) {
            counts = Counting.counted(counts, act);
        }
        return counts;
    }

    /** The share of dialogues in which the mean is within {@code l1} of the reference; 1 if there was none. */
    public double share(Method method, double l1) {
        List<Deviation> d = of(method);
        return d.isEmpty() ? 1 : d.stream().filter(x -> x.l1() < l1).count() / (double) d.size();
    }

    /**
     * The L1 error of the mean that a share of {@code level} (in [0, 1]) of the dialogues does not exceed; NaN if there
     * was none.
     */
    public double quantile(Method method, double level) {
        double[] sorted = of(method).stream().mapToDouble(Deviation::l1).sorted().toArray();
        return sorted.length == 0 ? Double.NaN : sorted[(int) Math.round(level * (sorted.length - 1))];
    }

    /** Average over the dialogues of the absolute values of each kind of deviation; NaN if there was none. */
    public Deviation average(Method method) {
        return new Deviation(of(method).stream().mapToDouble(Deviation::l1).average().orElse(Double.NaN),
                of(method).stream().mapToDouble(d -> Math.abs(d.variance())).average().orElse(Double.NaN),
                of(method).stream().mapToDouble(Deviation::relativeEntropy).average().orElse(Double.NaN),
                of(method).stream().mapToDouble(d -> Math.abs(d.score())).average().orElse(Double.NaN));
    }

    private List<Deviation> of(Method method) {
        return deviations.getOrDefault(method, List.of());
    }
}
