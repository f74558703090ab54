package handover.cli;

import handover.belief.HandoverBelief;
import handover.domain.ActModel;
import handover.domain.HandoverDomain;
import handover.domain.Scene;
import handover.math.Simplex;
import handover.math.Streams;
import handover.simulation.EpisodeRunner;
import handover.solver.BeliefMetric;
import handover.solver.BeliefSpace;
import handover.solver.Deadline;
import handover.solver.Decision;
import handover.solver.Policy;
import handover.solver.Solver;
import handover.solver.StoredBelief;
import java.util.ArrayList;
import java.util.List;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import java.util.random.RandomGenerator;

/**
 * Units of work of a precompute: beliefs that the policy will really reach, each with the teacher's decision. Unit 0 is the
 * prior and the corners; every other unit is one simulated episode. Of eight episodes four follow the teacher with people as
 * modelled, two follow it with an act at random now and then, one meets other people, and one has both. Unit k is a function of
 * seed and k alone, unless the teacher has a time limit. Thread safe.
 */
final class BeliefSampling {
    private static final int ROUND = 8;
    /** Probability of an act at random in a perturbed episode. */
    private static final double PERTURBED = 0.25;
    private static final long SEED_STREAM = 0x6e656172;

    private final HandoverDomain domain;
    private final List<HandoverDomain> others;
    private final Policy teacher;
    private final BeliefSpace space = new BeliefSpace(BeliefMetric.DEFAULT);
    private final long seed;
    private final Supplier<Deadline> deadlines;
    private final LongSupplier nanoClock;

    /**
     * @param others people other than the model, at least one
     * @param seed not that of the episodes themselves, so that evaluating with the same seed meets other people
     */
    BeliefSampling(HandoverDomain domain, List<HandoverDomain> others, Solver teacher, long seed, Supplier<Deadline> deadlines,
            LongSupplier nanoClock) {
        this.domain = domain;
        this.others = others;
        this.seed = Streams.mix(seed, SEED_STREAM);
        this.teacher = teacher.solve(domain, Streams.of(this.seed, "solve", 0));
        this.deadlines = deadlines;
        this.nanoClock = nanoClock;
    }

    /** Permutations of the objects at the start that one stored belief serves. */
    int symmetries() {
        return space.symmetries(domain.start());
    }

    /** The beliefs of one unit, in order. */
    List<StoredBelief> unit(int k) {
        return k == 0 ? corners() : episode(k);
    }

    private List<StoredBelief> corners() {
        Scene scene = domain.start();
        int n = scene.size();
        double[] uniform = Simplex.uniform(n);
        List<HandoverBelief> beliefs = new ArrayList<>();
        beliefs.add(HandoverBelief.initial(domain));
        beliefs.add(HandoverBelief.of(domain.task(scene), uniform, uniform));
        for (int i = 0; i < n; i++) {
            double[] corner = Simplex.vertex(n, i);
            beliefs.add(HandoverBelief.of(domain.task(scene), corner, uniform));
            beliefs.add(HandoverBelief.of(domain.task(scene), corner, corner));
            beliefs.add(HandoverBelief.of(domain.task(scene), uniform, corner));
        }
        RandomGenerator chance = Streams.of(seed, "planner", 0);
        return beliefs.stream().map(b -> space.stored(b, teacher.decide(b, deadlines.get(), chance))).toList();
    }

    private List<StoredBelief> episode(int k) {
        int kind = k % ROUND;
        boolean perturbed = kind == 1 || kind == 3 || kind == 5;
        boolean other = kind == 5 || kind == 7;
        HandoverDomain people = other ? others.get(k / ROUND % others.size()) : domain;
        Recording recording = new Recording(perturbed ? Streams.of(seed, "perturb", k) : null);
        new EpisodeRunner(domain, people, recording, seed, EpisodeRunner.STEP_LIMIT, deadlines, nanoClock).play(k);
        return recording.met;
    }

    /** The teacher, who writes down what it decides, whether or not that is then done. Plays one episode. */
    private final class Recording implements Solver {
        private final RandomGenerator perturbation;
        private final List<StoredBelief> met = new ArrayList<>();

        /** @param perturbation null for none */
        Recording(RandomGenerator perturbation) {
            this.perturbation = perturbation;
        }

        @Override
        public String name() {
            return "recording";
        }

        @Override
        public Policy solve(HandoverDomain on, RandomGenerator random) {
            return this::decide;
        }

        private Decision decide(HandoverBelief belief, Deadline deadline, RandomGenerator random) {
            Decision decision = teacher.decide(belief, deadline, random);
            met.add(space.stored(belief, decision));
            if (perturbation == null || perturbation.nextDouble() >= PERTURBED) {
                return decision;
            }
            List<ActModel> acts = belief.task().legalActs();
            return Decision.of(acts.get(perturbation.nextInt(acts.size())).act());
        }
    }
}
