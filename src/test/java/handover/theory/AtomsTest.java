package handover.theory;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.math.Simplex;
import handover.theory.Agent.Robot;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.ejml.dense.row.CommonOps_DDRM;
import org.junit.jupiter.api.Test;

/** Exact mixtures against the enumeration of everything that may have been perceived, and what is made of them. */
class AtomsTest {
    /** Mean and q of all 4^5 sequences of perceived acts, each followed by itself. */
    @Property(tries = 20)
    void equalsTheEnumerationOfPerceivedSequences(@ForAll @IntRange(min = 1, max = 6) int n, @ForAll long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        Transition<Robot> t = RandomTheory.transition(n, random);
        List<Perception<Robot>> acts = random.longs(5).mapToObj(s -> RandomTheory.perception(n, new SplittableRandom(s)))
                .toList();
        Categorical<Robot> start = RandomTheory.belief(n, random);
        Nested<Robot> b = Atoms.certain(start);
        for (Perception<Robot> act : acts) {
            b = b.updated(t, act);
        }
        double[] mean = new double[n];
        double q = enumerate(start, t, acts, 1, mean);
        assertArrayEquals(mean, b.mean(), 1e-12);
        assertEquals(q, b.meanSquare(), 1e-12);
        assertEquals(q, CommonOps_DDRM.trace(b.secondMoments()), 1e-12);
        assertEquals(1, CommonOps_DDRM.elementSum(b.secondMoments()), 1e-12);
    }

    private static double enumerate(Categorical<Robot> beta, Transition<Robot> t, List<Perception<Robot>> acts, double weight,
            double[] mean) {
        double q = 0;
        if (acts.isEmpty()) {
            for (int i = 0; i < mean.length; i++) {
                mean[i] += weight * beta.probabilities()[i];
                q += weight * beta.probabilities()[i] * beta.probabilities()[i];
            }
            return q;
        }
        Perception<Robot> act = acts.get(0);
        for (int a = 0; a < act.size(); a++) {
            q += enumerate(beta.updated(t, act.messages().get(a)), t, acts.subList(1, acts.size()),
                    weight * act.probabilities()[a], mean);
        }
        return q;
    }

    /** If nothing moves, only how often each act was perceived counts: 10 acts of 4 kinds give C(13, 3) = 286 atoms. */
    @Test
    void orderDoesNotMatterWhenNothingMoves() {
        Perception<Robot> act = RandomTheory.perception(5, new SplittableRandom(3));
        Atoms<Robot> b = Atoms.certain(Categorical.uniform(5));
        for (int k = 0; k < 10; k++) {
            b = b.perceived(act);
        }
        assertEquals(286, b.count());
    }

    /** Near a vertex, beliefs that differ only in what is all but impossible stay apart: later acts may bring it back. */
    @Test
    void mergingIsRelative() {
        Atoms<Robot> b = new Atoms<>(new double[] {0.5, 0.5}, List.of(new double[] {1, 1e-20}, new double[] {1, 1e-30}));
        Atoms<Robot> next = b.perceived(Perception.exact(new Message<>(new double[] {1e-25, 1})));
        assertEquals(2, next.count());
        assertEquals((1 / (1 + 1e5) * 1e5 + 1e-5) / 2 - 0.5, next.mean()[1] - 0.5, 1e-4);
        assertEquals(1, new Atoms<Robot>(new double[] {0.5, 0.5}, List.of(new double[] {0.3, 0.7},
                new double[] {0.3 + 1e-16, 0.7})).perceived(Perception.exact(Message.nothing(2))).count());
    }

    @Test
    void conditionsOnEvidence() {
        Atoms<Robot> b = new Atoms<>(new double[] {0.5, 0.5}, List.of(new double[] {0.9, 0.1}, new double[] {0.3, 0.7}));
        Evidence<Robot> e = new Evidence<>(new double[] {1, 0});
        assertEquals(0.6, b.probability(e), 1e-15);
        assertArrayEquals(new double[] {0.75, 0.25}, b.given(e).weights(), 1e-15);
        assertArrayEquals(b.weights(), b.given(new Evidence<>(new double[2])).weights());
    }

    /** An answer that only a perceived act explains moves the weight of what was perceived; so it moves B. */
    @Test
    void anAnswerTellsWhatWasPerceived() {
        List<Message<Robot>> acts = List.of(new Message<>(new double[] {0.9, 0.1}), new Message<>(new double[] {0.1, 0.9}));
        Perception<Robot> heard = Perception.confused(acts, 0, 0.8, 0.25);
        assertArrayEquals(new double[] {0.6, 0.2, 0.2}, heard.probabilities(), 1e-15);
        Perception<Robot> after = heard.given(new double[] {0, 0.5, 0.25});
        assertArrayEquals(new double[] {0, 2 / 3.0, 1 / 3.0}, after.probabilities(), 1e-15);
        assertEquals(0.15, heard.probability(new double[] {0, 0.5, 0.25}), 1e-15);
        Atoms<Robot> b = Atoms.certain(Categorical.uniform(2));
        assertEquals(0.1 * 2 / 3 + 0.5 / 3, b.perceived(after).mean()[0], 1e-15);
        assertThrows(IllegalArgumentException.class, () -> heard.given(new double[2]));
    }

    @Test
    void particlesAreExactUpToTheLimit() {
        SplittableRandom random = new SplittableRandom(4);
        Transition<Robot> t = Transition.stay(4, 0.9);
        Nested<Robot> exact = Atoms.certain(Categorical.uniform(4));
        Nested<Robot> particles = Particles.certain(Categorical.uniform(4), 256, random);
        Nested<Robot> clusters = Clusters.certain(Categorical.uniform(4), 256);
        for (int k = 0; k < 4; k++) {
            Perception<Robot> act = RandomTheory.perception(4, random);
            exact = exact.updated(t, act);
            particles = particles.updated(t, act);
            clusters = clusters.updated(t, act);
        }
        assertArrayEquals(exact.mean(), particles.mean(), 1e-15);
        assertArrayEquals(exact.mean(), clusters.mean(), 1e-15);
    }

    /**
     * The threshold solves its equation, and the survivors of 20,000 reductions average to the weights (4 sigma, 6 of
     * them).
     */
    @Test
    void resamplingIsUnbiased() {
        SplittableRandom random = new SplittableRandom(5);
        double[] w = {0.4, 0.25, 0.15, 0.1, 0.06, 0.04};
        double c = Resampling.threshold(w, 3);
        assertEquals(3, Arrays.stream(w).map(x -> Math.min(x / c, 1)).sum(), 1e-12);
        Atoms<Robot> atoms = new Atoms<>(w, List.of(Simplex.vertex(6, 0), Simplex.vertex(6, 1), Simplex.vertex(6, 2),
                Simplex.vertex(6, 3), Simplex.vertex(6, 4), Simplex.vertex(6, 5)));
        double[] sum = new double[6];
        int runs = 20_000;
        for (int r = 0; r < runs; r++) {
            Atoms<Robot> kept = Resampling.reduced(atoms, 3, random);
            assertTrue(kept.count() <= 4);
            double[] m = kept.mean();
            for (int i = 0; i < 6; i++) {
                sum[i] += m[i];
            }
        }
        for (int i = 0; i < 6; i++) {
            double error = w[i] >= c ? 1e-12 : Math.sqrt(w[i] * (c - w[i]) / runs);
            assertEquals(w[i], sum[i] / runs, 4 * error + 1e-12);
        }
    }

    /** Merging near beliefs keeps the mean to the last digits and never adds variance. */
    @Property(tries = 50)
    void clusteringKeepsTheMean(@ForAll @IntRange(min = 1, max = 8) int n, @ForAll @IntRange(min = 1, max = 20) int limit,
            @ForAll long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        Particles<Robot> many = Particles.of(DirichletBelief.of(RandomDirichlets.alpha(n, random), Projection.MOMENTS), 60,
                random);
        Clusters<Robot> few = new Clusters<>(many.atoms(), limit);
        assertTrue(few.atoms().count() <= limit);
        assertArrayEquals(many.mean(), few.mean(), 1e-12);
        assertTrue(few.variance() <= many.variance() + 1e-12);
    }
}
