package handover.theory;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.math.Simplex;
import handover.theory.Agent.Human;
import handover.theory.Agent.Robot;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

/** The joint belief about what is wanted and what is believed, against enumeration. */
class JointBeliefTest {
    private static double[][] answer(Perception<Robot> act, int n, SplittableRandom random) {
        double[][] l = new double[act.size()][];
        for (int a = 0; a < l.length; a++) {
            l[a] = random.doubles(n, 0.05, 1).toArray();
        }
        return l;
    }

    /** Three acts with answers, both choices moving: p(iota, beta) summed over all that may have been perceived. */
    @Property(tries = 30)
    void equalsTheEnumeration(@ForAll @IntRange(min = 1, max = 5) int n, @ForAll long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        Transition<Robot> own = RandomTheory.transition(n, random);
        Transition<Human> other = RandomTheory.transition(n, random);
        Categorical<Human> b = RandomTheory.belief(n, random);
        Categorical<Robot> beta = RandomTheory.belief(n, random);
        List<Perception<Robot>> acts = new ArrayList<>();
        List<double[][]> answers = new ArrayList<>();
        JointBelief<Robot, Human> joint = JointBelief.of(b, beta, 1000);
        for (int t = 0; t < 3; t++) {
            acts.add(RandomTheory.perception(n, random));
            answers.add(answer(acts.get(t), n, random));
            joint = joint.predicted(own, other).perceived(acts.get(t), answers.get(t));
        }
        double[] wanted = new double[n];
        double[] expected = new double[n];
        enumerate(beta, b.probabilities(), own, other, acts, answers, 0, wanted, expected);
        double z = Simplex.normalise(wanted, n);
        assertArrayEquals(wanted, joint.belief().probabilities(), 1e-12);
        for (int i = 0; i < n; i++) {
            assertEquals(expected[i] / z, joint.nested().mean()[i], 1e-12);
        }
    }

    private static void enumerate(Categorical<Robot> beta, double[] row, Transition<Robot> own, Transition<Human> other,
            List<Perception<Robot>> acts, List<double[][]> answers, int t, double[] wanted, double[] expected) {
        double total = Simplex.sum(row, row.length);
        if (t == acts.size()) {
            for (int i = 0; i < row.length; i++) {
                wanted[i] += row[i];
                expected[i] += total * beta.probabilities()[i];
            }
            return;
        }
        Perception<Robot> act = acts.get(t);
        for (int a = 0; a < act.size(); a++) {
            double[] next = other.moved(row);
            for (int i = 0; i < row.length; i++) {
                next[i] *= act.probabilities()[a] * answers.get(t)[a][i];
            }
            enumerate(beta.updated(own, act.messages().get(a)), next, own, other, acts, answers, t + 1, wanted, expected);
        }
    }

    /** One answer: the marginals are those of equation (14) of docs/theory.md. */
    @Property(tries = 30)
    void marginalsAfterOneAnswer(@ForAll @IntRange(min = 1, max = 5) int n, @ForAll long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        Categorical<Human> b = RandomTheory.belief(n, random);
        Categorical<Robot> beta = RandomTheory.belief(n, random);
        Perception<Robot> act = RandomTheory.perception(n, random);
        double[][] l = answer(act, n, random);
        double[] perceived = new double[act.size()];
        double[] wanted = new double[n];
        for (int a = 0; a < act.size(); a++) {
            for (int i = 0; i < n; i++) {
                perceived[a] += b.probabilities()[i] * l[a][i];
                wanted[i] += b.probabilities()[i] * act.probabilities()[a] * l[a][i];
            }
        }
        Simplex.normalise(wanted, n);
        JointBelief<Robot, Human> joint = JointBelief.of(b, beta, 100).perceived(act, l);
        assertArrayEquals(Atoms.certain(beta).perceived(act.given(perceived)).mean(), joint.nested().mean(), 1e-12);
        assertArrayEquals(wanted, joint.belief().probabilities(), 1e-12);
    }

    /** Perceived as meant: one belief, and two filters side by side. */
    @Test
    void withoutMisperceptionItIsTheTwoFilters() {
        SplittableRandom random = new SplittableRandom(12);
        Transition<Robot> own = Transition.stay(4, 0.95);
        Transition<Human> other = Transition.stay(4, 0.9);
        Categorical<Human> b = Categorical.uniform(4);
        Categorical<Robot> beta = Categorical.uniform(4);
        JointBelief<Robot, Human> joint = JointBelief.of(b, beta, 1);
        for (int t = 0; t < 20; t++) {
            Message<Robot> act = RandomTheory.message(4, random);
            Message<Human> sensed = RandomTheory.message(4, random);
            joint = joint.predicted(own, other).perceived(Perception.exact(act), new double[][] {sensed.likelihood()});
            b = b.updated(other, sensed);
            beta = beta.updated(own, act);
            assertEquals(1, joint.points().size());
            assertArrayEquals(b.probabilities(), joint.belief().probabilities(), 1e-12);
            assertArrayEquals(beta.probabilities(), joint.nested().mean(), 1e-12);
        }
    }

    /** Speaking up because the wanted object is not expected: p = 0.3 (1 - beta_iota). */
    @Test
    void evidenceAboutBoth() {
        JointBelief<Robot, Human> joint = new JointBelief<>(List.of(new double[] {0.9, 0.1}, new double[] {0.5, 0.5}),
                List.of(new double[] {0.25, 0.25}, new double[] {0.25, 0.25}), 10);
        List<Evidence<Robot>> speaks = List.of(new Evidence<>(new double[] {0, 0.3}), new Evidence<>(new double[] {0.3, 0}));
        JointBelief<Robot, Human> next = joint.given(speaks);
        assertArrayEquals(new double[] {0.1 / 2, 0.9 / 2}, next.weights().get(0), 1e-15);
        assertArrayEquals(new double[] {0.5 / 2, 0.5 / 2}, next.weights().get(1), 1e-15);
        assertArrayEquals(new double[] {1, 0}, joint.given(new Message<Human>(new double[] {1, 0})).belief().probabilities());
    }

    @Test
    void whatIsImpossibleIsLeftOut() {
        JointBelief<Robot, Human> joint = JointBelief.of(new Categorical<Human>(new double[] {1, 0}),
                Categorical.<Robot>uniform(2), 10);
        assertEquals(joint, joint.given(new Message<>(new double[] {0, 1})));
        Perception<Robot> act = Perception.exact(new Message<>(new double[] {0.8, 0.2}));
        JointBelief<Robot, Human> next = joint.perceived(act, new double[][] {{0, 1}});
        assertArrayEquals(new double[] {1, 0}, next.belief().probabilities());
        assertArrayEquals(new double[] {0.8, 0.2}, next.nested().mean(), 1e-15);
    }

    /** Bounded: merging keeps both means, up to what later acts make of the difference. */
    @Test
    void staysWithinTheLimit() {
        SplittableRandom random = new SplittableRandom(13);
        Categorical<Human> b = Categorical.uniform(4);
        Categorical<Robot> beta = Categorical.uniform(4);
        JointBelief<Robot, Human> exact = JointBelief.of(b, beta, 100_000);
        JointBelief<Robot, Human> few = JointBelief.of(b, beta, 50);
        Transition<Robot> own = Transition.stay(4, 0.95);
        Transition<Human> other = Transition.stay(4, 1);
        for (int t = 0; t < 6; t++) {
            Perception<Robot> act = RandomTheory.perception(4, random);
            double[][] l = answer(act, 4, random);
            exact = exact.predicted(own, other).perceived(act, l);
            few = few.predicted(own, other).perceived(act, l);
        }
        assertEquals(4096, exact.points().size());
        assertTrue(few.points().size() <= 50);
        assertEquals(0, Simplex.l1(exact.belief().probabilities(), few.belief().probabilities()), 1e-12);
        assertEquals(0, Simplex.l1(exact.nested().mean(), few.nested().mean()), 0.01);
    }
}
