package handover.theory;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import handover.theory.Agent.Human;
import handover.theory.Agent.Robot;
import java.util.SplittableRandom;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

/** Item and categorical level against MODEL 3.2, 4.4 and 8 written as loops. */
class CategoricalTest {
    @Property(tries = 200)
    void updateEqualsTheModelWrittenAsLoops(@ForAll @IntRange(min = 1, max = 100) int n,
            @ForAll @DoubleRange(min = 0, max = 1) double stay, @ForAll long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        double[] lambda = RandomDirichlets.likelihood(n, random);
        double[] h = RandomDirichlets.belief(n, random);
        double[] expected = new double[n];
        double z = 0;
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                double t = n == 1 ? 1 : i == j ? stay : (1 - stay) / (n - 1);
                expected[i] += t * h[j];
            }
            expected[i] *= lambda[i];
            z += expected[i];
        }
        for (int i = 0; i < n; i++) {
            expected[i] /= z;
        }
        Categorical<Robot> beta = new Categorical<>(h);
        Transition<Robot> t = Transition.stay(n, stay);
        Message<Robot> a = new Message<>(lambda);
        assertArrayEquals(expected, beta.updated(t, a).probabilities(), 1e-12);
        assertArrayEquals(expected, beta.predicted(t).given(a).probabilities(), 1e-12);
    }

    @Property(tries = 100)
    void anyTransitionEqualsLoops(@ForAll @IntRange(min = 1, max = 30) int n, @ForAll long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        Transition<Human> first = RandomTheory.transition(n, random);
        Transition<Human> second = RandomTheory.transition(n, random);
        Categorical<Human> b = RandomTheory.belief(n, random);
        double[] expected = new double[n];
        for (int j = 0; j < n; j++) {
            for (int i = 0; i < n; i++) {
                expected[i] += first.matrix().get(j, i) * b.probabilities()[j];
            }
        }
        assertArrayEquals(expected, b.predicted(first).probabilities(), 1e-12);
        assertArrayEquals(b.predicted(first).predicted(second).probabilities(),
                b.predicted(first.then(second)).probabilities(), 1e-12);
    }

    @Property(tries = 100)
    void theRobotCompliesAsTheItemLevelSays(@ForAll @IntRange(min = 1, max = 20) int n,
            @ForAll @DoubleRange(min = 0, max = 1) double c, @ForAll long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        Message<Human> heard = RandomTheory.message(n, random);
        double[] p = RandomDirichlets.belief(n, random);
        double sum = 0;
        for (double l : heard.likelihood()) {
            sum += l;
        }
        double[] expected = new double[n];
        for (int i = 0; i < n; i++) {
            for (int k = 0; k < n; k++) {
                expected[i] += ((i == k ? 1 - c : 0) + c * heard.likelihood()[i] / sum) * p[k];
            }
        }
        Choice<Robot> own = new Choice<>(p);
        assertArrayEquals(expected, own.moved(Transition.compliance(c, heard)).probabilities(), 1e-12);
    }

    @Test
    void whatIsImpossibleForEveryObjectIsUninformative() {
        Categorical<Robot> beta = new Categorical<>(new double[] {1, 0, 0});
        assertEquals(beta, beta.given(new Message<>(new double[] {0, 0.5, 0.5})));
        assertEquals(beta, beta.given(new Message<>(new double[3])));
        Transition<Robot> t = Transition.stay(3, 0.9);
        assertEquals(beta.predicted(t), beta.updated(t, new Message<>(new double[3])));
        assertArrayEquals(new double[] {1, 0, 0}, new Choice<Robot>(new double[] {1, 0, 0})
                .moved(Transition.compliance(0.7, new Message<Human>(new double[3]))).probabilities());
    }

    @Test
    void tinyLikelihoodsDoNotUnderflow() {
        Categorical<Robot> beta = Categorical.uniform(2);
        assertArrayEquals(new double[] {0.75, 0.25}, beta.updated(Transition.stay(2, 1),
                new Message<>(new double[] {3e-320, 1e-320})).probabilities(), 1e-3);
        assertArrayEquals(new double[] {0.75, 0.25}, beta.given(new Message<>(new double[] {3e-300, 1e-300}))
                .probabilities(), 1e-12);
    }

    @Test
    void refusesWhatIsNoDistribution() {
        assertThrows(IllegalArgumentException.class, () -> new Categorical<Robot>(new double[] {0.5, 0.4}));
        assertThrows(IllegalArgumentException.class, () -> new Choice<Robot>(new double[] {1.5, -0.5}));
        assertThrows(IllegalArgumentException.class, () -> new Message<Robot>(new double[] {Double.NaN}));
        assertThrows(IllegalArgumentException.class, () -> Transition.<Robot>stay(2, 1.5));
        assertThrows(IllegalArgumentException.class,
                () -> Categorical.<Robot>uniform(2).given(new Message<>(new double[3])));
    }
}
