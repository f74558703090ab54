package handover.theory;

import handover.theory.Agent.Robot;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.ejml.data.DMatrixRMaj;

/** Random acts, transitions and beliefs for the tests. */
final class RandomTheory {
    private RandomTheory() {}

    static <S extends Agent<?, ?>> Message<S> message(int n, SplittableRandom random) {
        return new Message<>(random.doubles(n, 0.01, 1).toArray());
    }

    static <S extends Agent<?, ?>> Categorical<S> belief(int n, SplittableRandom random) {
        return new Categorical<>(RandomDirichlets.belief(n, random));
    }

    static <S extends Agent<?, ?>> Transition<S> transition(int n, SplittableRandom random) {
        DMatrixRMaj t = new DMatrixRMaj(n, n);
        for (int j = 0; j < n; j++) {
            System.arraycopy(RandomDirichlets.belief(n, random), 0, t.data, j * n, n);
        }
        return new Transition<>(t);
    }

    /** Three acts that may be perceived, and a missed one. */
    static Perception<Robot> perception(int n, SplittableRandom random) {
        List<Message<Robot>> acts = new ArrayList<>();
        for (int a = 0; a < 3; a++) {
            acts.add(message(n, random));
        }
        return Perception.confused(acts, random.nextInt(3), 0.8, 0.3);
    }
}
