package handover.cli;

import handover.domain.DomainSpec;
import handover.domain.PerceptionParameters;
import handover.math.Simplex;
import handover.math.Streams;
import handover.theory.Agent.Robot;
import handover.theory.Categorical;
import handover.theory.Clusters;
import handover.theory.Deviation;
import handover.theory.Dialogue;
import handover.theory.DialogueSettings;
import handover.theory.DirichletBelief;
import handover.theory.Nested;
import handover.theory.Particles;
import handover.theory.Projection;
import handover.theory.ProjectionStudy;
import handover.theory.ProjectionStudy.Method;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.LongSupplier;
import java.util.random.RandomGenerator;

/** Representations of B against particles, over random dialogues at the perception and tau_H of a domain. */
final class ProjectionTables {
    private static final int CLUSTERS = 50;
    private static final double CLOSE = 0.01;
    private static final double LEVEL = 0.95;
    private static final int[] LENGTHS = {1, 3, 10, 30};
    private static final int TIMED = 20;

    private final DomainSpec spec;
    private final int dialogues;
    private final int particles;
    private final long seed;
    private final LongSupplier nanoClock;

    ProjectionTables(DomainSpec spec, int dialogues, int particles, long seed, LongSupplier nanoClock) {
        this.spec = spec;
        this.dialogues = dialogues;
        this.particles = particles;
        this.seed = seed;
        this.nanoClock = nanoClock;
    }

    private DialogueSettings settings(int objects, int acts, PerceptionParameters p) {
        double noticed = 1 - p.missed();
        DialogueSettings d = DialogueSettings.of(objects);
        return new DialogueSettings(objects, acts, spec.tauHuman(), noticed, noticed == 0 ? 0 : Math.min(1, p.misread() / noticed),
                d.narrowest(), d.widest(), d.concentration());
    }

    private ProjectionStudy study(DialogueSettings settings) {
        return ProjectionStudy.run(settings, dialogues, particles, CLUSTERS, Streams.of(seed, "dialogues", settings.objects()));
    }

    /** Errors of each method after ten acts. */
    String errors(List<Integer> sizes) {
        TextTable table = new TextTable(40, List.of("B as", "N", "within 0.01 %", "95% quantile", "L1 of mean", "variance", "KL", "Brier"));
        for (int n : sizes) {
            ProjectionStudy study = study(settings(n, 10, spec.perception()));
            for (Method method : Method.values()) {
                Deviation d = study.average(method);
                table.add(List.of(name(method), String.valueOf(n), show("%.1f", 100 * study.share(method, CLOSE)),
                        show("%.4f", study.quantile(method, LEVEL)), show("%.4f", d.l1()), show("%.4f", d.variance()),
                        show("%.4f", d.relativeEntropy()), show("%.4f", d.score())));
            }
        }
        return "B, the belief over the human's belief, after ten acts of which " + show("%.0f%%", 100 * spec.perception().missed())
                + " are missed and " + show("%.0f%%", 100 * spec.perception().misread()) + " misread,\nagainst " + particles
                + " particles, " + dialogues + " random dialogues for each N: share of dialogues whose E[beta] is within 0.01 (L1),"
                + "\nits 95% quantile, and mean absolute errors.\n\n" + table.text();
    }

    /** Errors of counting by the number of acts, with and without misperception. */
    String counting() {
        TextTable table = new TextTable(40, List.of("acts", "missed", "misread", "counting", "Dirichlet", "50 clusters"));
        for (PerceptionParameters p : List.of(PerceptionParameters.EXACT, spec.perception())) {
            for (int acts : LENGTHS) {
                ProjectionStudy study = study(settings(spec.objects().size(), acts, p));
                table.add(List.of(String.valueOf(acts), show("%.2f", p.missed()), show("%.2f", p.misread()),
                        show("%.4f", study.average(Method.COUNTING).l1()), show("%.4f", study.average(Method.DIRICHLET).l1()),
                        show("%.4f", study.average(Method.CLUSTERS).l1())));
            }
        }
        return "When counting (alpha_j += ...) goes wrong: L1 error of E[beta] by the number of acts, N = " + spec.objects().size()
                + ".\n\n" + table.text();
    }

    /** Microseconds for each act; the only numbers that depend on the machine. */
    String costs(List<Integer> sizes) {
        TextTable table = new TextTable(40, List.of("B as", "N", "microseconds an act"));
        for (int n : sizes) {
            DialogueSettings settings = settings(n, 10, spec.perception());
            List<Dialogue> played = new ArrayList<>();
            RandomGenerator random = Streams.of(seed, "dialogues", n);
            for (int k = 0; k < Math.min(dialogues, TIMED); k++) {
                played.add(Dialogue.random(settings, random));
            }
            starts(n, random).forEach((name, start) -> table.add(List.of(name, String.valueOf(n), show("%.0f", micros(played, start)))));
        }
        return "What an act costs:\n\n" + table.text();
    }

    private static Map<String, Nested<Robot>> starts(int n, RandomGenerator random) {
        Map<String, Nested<Robot>> all = new LinkedHashMap<>();
        Categorical<Robot> known = Categorical.uniform(n);
        all.put("50 clusters", Clusters.certain(known, CLUSTERS));
        all.put("10 clusters", Clusters.certain(known, CLUSTERS / 5));
        all.put("Dirichlet", new DirichletBelief<>(Simplex.uniform(n), Double.POSITIVE_INFINITY, Projection.MOMENTS));
        all.put("Dirichlet, log moments", new DirichletBelief<>(Simplex.uniform(n), Double.POSITIVE_INFINITY, Projection.LOG_MOMENTS));
        all.put("1,000 particles", Particles.certain(known, 1000, random));
        return all;
    }

    /** Once to warm up, once for the clock. */
    private double micros(List<Dialogue> played, Nested<Robot> start) {
        played.forEach(d -> d.follow(start));
        long before = nanoClock.getAsLong();
        played.forEach(d -> d.follow(start));
        return (nanoClock.getAsLong() - before) / 1e3 / played.stream().mapToInt(d -> d.acts().size()).sum();
    }

    private static String name(Method method) {
        return switch (method) {
            case PARTICLES -> "particles again";
            case CLUSTERS -> CLUSTERS + " clusters";
            case DIRICHLET -> "Dirichlet";
            case DIRICHLET_LOG -> "Dirichlet, log moments";
            case COUNTING -> "counting";
        };
    }

    private static String show(String format, Object... values) {
        return String.format(Locale.ROOT, format, values);
    }
}
