package handover.cli;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.ActModel;
import handover.domain.DomainSpec;
import handover.domain.HandoverDomain;
import handover.domain.HandoverModel;
import handover.domain.HandoverObservationFunction;
import handover.domain.HandoverState;
import handover.domain.Observation;
import handover.domain.PerceptionParameters;
import handover.io.DomainFiles;
import handover.math.Simplex;
import handover.math.Streams;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.LongSupplier;
import java.util.random.RandomGenerator;

/** The robot's filter with few minds against the same with all of them, over random dialogues of a domain. */
final class FilterTable {
    private static final int[] LIMITS = {1, 5, 10, 20, 50};
    private static final int ALL = 100_000;
    private static final int ACTS = 6;

    private final DomainSpec spec;
    private final int dialogues;
    private final long seed;
    private final LongSupplier nanoClock;

    FilterTable(DomainSpec spec, int dialogues, long seed, LongSupplier nanoClock) {
        this.spec = spec;
        this.dialogues = dialogues;
        this.seed = seed;
        this.nanoClock = nanoClock;
    }

    /** What the robot did, and what it sensed. */
    private record Heard(Act act, Observation observation) {}

    /** Errors of b and E[beta], and the time of an update. */
    String text() {
        List<List<Heard>> played = new ArrayList<>();
        for (int k = 0; k < dialogues; k++) {
            played.add(dialogue(Streams.of(seed, "filter", k)));
        }
        List<List<HandoverBelief>> right = follow(with(ALL), played);
        TextTable table = new TextTable(40, List.of("robot keeps", "L1 of b", "largest", "L1 of E[beta]", "largest", "microseconds a step"));
        add(table, "nothing: takes itself to be understood", with(PerceptionParameters.EXACT), played, right);
        for (int limit : LIMITS) {
            add(table, limit + (limit == 1 ? " mind" : " minds"), with(limit), played, right);
        }
        return "The robot's belief on " + spec.name() + " after each of " + ACTS + " acts, against all minds, " + dialogues
                + " random dialogues: mean and largest errors.\n\n" + table.text();
    }

    private HandoverDomain with(int minds) {
        PerceptionParameters p = spec.perception();
        return with(new PerceptionParameters(p.missed(), p.misread(), minds));
    }

    private HandoverDomain with(PerceptionParameters perception) {
        return DomainFiles.domain(spec.with(s -> s.perception = perception));
    }

    /** Random acts but picks, and what a human of the domain does. */
    private List<Heard> dialogue(RandomGenerator random) {
        HandoverDomain people = DomainFiles.domain(spec);
        HandoverModel model = new HandoverModel(people, random);
        HandoverObservationFunction senses = new HandoverObservationFunction(people, random);
        List<Act> acts = people.start().acts().stream().filter(m -> !m.isPick()).map(ActModel::act).toList();
        double[] prior = people.prior(people.start());
        HandoverState state = new HandoverState(Simplex.sample(prior, prior.length, random), people.task(people.start()),
                Simplex.uniform(prior.length));
        List<Heard> all = new ArrayList<>();
        for (int k = 0; k < ACTS; k++) {
            Act act = acts.get(random.nextInt(acts.size()));
            state = (HandoverState) model.sample(state, act).op;
            all.add(new Heard(act, senses.sample(state, act)));
        }
        return all;
    }

    private static List<List<HandoverBelief>> follow(HandoverDomain domain, List<List<Heard>> played) {
        return played.stream().map(dialogue -> {
            List<HandoverBelief> beliefs = new ArrayList<>();
            HandoverBelief belief = HandoverBelief.initial(domain);
            for (Heard h : dialogue) {
                belief = belief.after(h.act).given(h.observation);
                beliefs.add(belief);
            }
            return beliefs;
        }).toList();
    }

    private void add(TextTable table, String name, HandoverDomain domain, List<List<Heard>> played, List<List<HandoverBelief>> right) {
        follow(domain, played);
        long before = nanoClock.getAsLong();
        List<List<HandoverBelief>> beliefs = follow(domain, played);
        double micros = (nanoClock.getAsLong() - before) / 1e3 / (dialogues * (double) ACTS);
        double[] b = new double[2];
        double[] h = new double[2];
        for (int k = 0; k < dialogues; k++) {
            for (int t = 0; t < ACTS; t++) {
                HandoverBelief found = beliefs.get(k).get(t);
                HandoverBelief exact = right.get(k).get(t);
                tally(Simplex.l1(found.probabilities(), exact.probabilities()), b);
                tally(Simplex.l1(found.human(), exact.human()), h);
            }
        }
        double count = dialogues * (double) ACTS;
        table.add(List.of(name, show("%.5f", b[0] / count), show("%.4f", b[1]), show("%.5f", h[0] / count), show("%.4f", h[1]),
                show("%.0f", micros)));
    }

    /** Adds to the sum and the largest (modified). */
    private static void tally(double error, double[] sumAndLargest) {
        sumAndLargest[0] += error;
        sumAndLargest[1] = Math.max(sumAndLargest[1], error);
    }

    private static String show(String format, Object... values) {
        return String.format(Locale.ROOT, format, values);
    }
}
