package handover.simulation;

import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.ActModel;
import handover.domain.DomainSpec;
import handover.domain.HandoverDomain;
import handover.domain.SpeechParameters;
import handover.domain.TableObject;
import handover.domain.WrongPick;
import handover.math.Simplex;
import handover.math.Vector3;
import handover.solver.Confirm;
import handover.solver.Deadline;
import handover.solver.RandomActs;
import handover.solver.Solver;
import handover.solver.Threshold;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.function.Consumer;
import java.util.random.RandomGenerator;
import java.util.stream.Stream;
import org.hipparchus.distribution.continuous.ChiSquaredDistribution;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * What is believed at p is wanted p of the time, over simulated episodes of people who are as the robot thinks.
 *
 * <p>Of each episode one step counts, whose number is drawn before the episode: a step drawn from those that happened would
 * favour short episodes, and whether an episode is short depends on what is wanted. Of that step one object counts, so that
 * the trials are independent. False alarm: about 1e-6 a test.
 */
class CalibrationTest {
    private static final int EPISODES = 3000;
    private static final int LATEST = 8;
    private static final int BINS = 10;
    private static final double FALSE_ALARM = 1e-6;

    private static DomainSpec spec(Consumer<DomainSpec.Fields> change) {
        List<TableObject> objects = List.of(
                new TableObject("a", new Vector3(-0.3, 0.6, 0), Map.of("red", 3.0, "ball", 2.0), "red ball"),
                new TableObject("b", new Vector3(-0.1, 0.6, 0), Map.of("red", 2.0, "cup", 2.0), "red cup"),
                new TableObject("c", new Vector3(0.1, 0.6, 0), Map.of("blue", 3.0, "cup", 1.0), "blue cup"),
                new TableObject("d", new Vector3(0.3, 0.6, 0), Map.of("blue", 1.0, "ball", 1.0), "blue ball"));
        return DomainSpec.of("x", objects).with(s -> {
            s.prior = Map.of("a", 0.1, "b", 0.2, "c", 0.3, "d", 0.4);
            s.speech = new SpeechParameters(0.5, 0.05, 0.5, 0.3, 0.1, List.of(0.5, 0.3, 0.2));
            change.accept(s);
        });
    }

    static Stream<Solver> solvers() {
        return Stream.of(new Threshold(0.9), new Confirm(), new RandomActs());
    }

    @ParameterizedTest
    @MethodSource("solvers")
    void episodesOfEverySolver(Solver solver) {
        HandoverDomain domain = new HandoverDomain(spec(s -> {}));
        EpisodeRunner runner = new EpisodeRunner(domain, domain, solver, 81, LATEST + 1, () -> Deadline.NONE, () -> 0);
        Tally tally = new Tally();
        RandomGenerator random = new SplittableRandom(82);
        for (int k = 0; k < EPISODES; k++) {
            Episode episode = runner.play(k);
            int step = random.nextInt(LATEST);
            // With tau = 1 and one handover the wish stays until the end, at which nothing is left to believe.
            if (step < episode.steps().size() && !episode.steps().get(step).belief().task().done()) {
                HandoverBelief belief = episode.steps().get(step).belief();
                tally.add(belief.probabilities(), belief.scene().indexOf(episode.wanted()), random);
            }
        }
        tally.assertCalibrated(solver.name());
    }

    static Stream<DomainSpec> courses() {
        return Stream.of(spec(s -> s.tau = 0.9),
                spec(s -> {
                    s.tau = 0.95;
                    s.handovers = 3;
                    s.wrongPick = WrongPick.REMOVED;
                }),
                spec(s -> {
                    s.handovers = 4;
                    s.wrongPick = WrongPick.RETURNED;
                }));
    }

    /** Wishes that change, several handovers: what is wanted at that step is taken from the simulated world itself. */
    @ParameterizedTest
    @MethodSource("courses")
    void wishesThatChange(DomainSpec spec) {
        HandoverDomain domain = new HandoverDomain(spec);
        Tally tally = new Tally();
        RandomGenerator random = new SplittableRandom(83);
        for (int k = 0; k < EPISODES; k++) {
            World world = new World(domain, 84, k);
            HandoverBelief belief = HandoverBelief.initial(domain);
            for (int steps = 1 + random.nextInt(LATEST); steps > 0 && !belief.task().done(); steps--) {
                List<ActModel> acts = belief.task().legalActs();
                Act act = acts.get(random.nextInt(acts.size())).act();
                world.step(act);
                belief = belief.after(act).given(world.react(act));
            }
            if (!belief.task().done()) {
                tally.add(belief.probabilities(), world.state().wanted(), random);
            }
        }
        tally.assertCalibrated("tau " + spec.tau() + ", " + spec.handovers() + " handovers, " + spec.wrongPick());
    }

    @Test
    void theTestFindsOverconfidence() {
        Tally tally = new Tally();
        RandomGenerator random = new SplittableRandom(85);
        for (int k = 0; k < EPISODES; k++) {
            double p = 0.5 + 0.5 * random.nextDouble();
            tally.add(new double[] {p, 1 - p}, random.nextDouble() < 0.8 * p + 0.1 ? 0 : 1, random);
        }
        assertTrue(tally.odds() < FALSE_ALARM, "odds of beliefs that are too sure by up to 10%: " + tally.odds());
    }

    /** Trials by how much was believed: in each bin, hits minus expected hits, with the variance of their sum. */
    private static final class Tally {
        private final double[] excess = new double[BINS];
        private final double[] variance = new double[BINS];
        private final int[] trials = new int[BINS];

        /** Half of the trials are about any object, half about one drawn from the belief, so that high ones come too. */
        void add(double[] b, int wanted, RandomGenerator random) {
            int x = random.nextBoolean() ? random.nextInt(b.length) : Simplex.sample(b, b.length, random);
            int bin = (int) Math.min(BINS - 1, b[x] * BINS);
            excess[bin] += (x == wanted ? 1 : 0) - b[x];
            variance[bin] += b[x] * (1 - b[x]);
            trials[bin]++;
        }

        double odds() {
            double statistic = 0;
            int used = 0;
            for (int k = 0; k < BINS; k++) {
                if (variance[k] >= 3) {
                    statistic += excess[k] * excess[k] / variance[k];
                    used++;
                }
            }
            return 1 - new ChiSquaredDistribution(used).cumulativeProbability(statistic);
        }

        void assertCalibrated(String what) {
            int all = java.util.Arrays.stream(trials).sum();
            assertTrue(all >= 500, () -> what + ": only " + all + " trials");
            StringBuilder table = new StringBuilder(what + ", odds " + odds());
            for (int k = 0; k < BINS; k++) {
                table.append(String.format("%n%.1f..%.1f: %d trials, %.1f hits too many, sd %.1f", k / 10.0, (k + 1) / 10.0,
                        trials[k], excess[k], Math.sqrt(variance[k])));
            }
            assertTrue(odds() >= FALSE_ALARM, table::toString);
        }
    }
}
