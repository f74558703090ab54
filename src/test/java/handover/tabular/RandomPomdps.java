package handover.tabular;

import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;

/** Small POMDPs with random numbers, some of them 0. */
final class RandomPomdps {
    private RandomPomdps() {}

    static TabularPomdp of(long seed, double discount) {
        SplittableRandom random = new SplittableRandom(seed);
        int n = 1 + random.nextInt(3);
        int acts = 1 + random.nextInt(3);
        int senses = 1 + random.nextInt(3);
        TabularBuilder to = new TabularBuilder(discount, names("s", n), names("a", acts), names("o", senses));
        to.start(row(random, n));
        for (int a = 0; a < acts; a++) {
            for (int s = 0; s < n; s++) {
                double[] next = row(random, n);
                double[] seen = row(random, senses);
                for (int k = 0; k < n; k++) {
                    to.transition(a, s, k, next[k]);
                }
                for (int o = 0; o < senses; o++) {
                    to.observation(a, s, o, seen[o]);
                }
                to.reward(a, s, -1, -1, random.nextDouble(-10, 10));
                if (random.nextInt(3) == 0) {
                    to.reward(a, s, random.nextInt(n), random.nextBoolean() ? -1 : random.nextInt(senses), random.nextDouble(-10, 10));
                }
            }
        }
        return to.build();
    }

    private static List<String> names(String letter, int n) {
        return IntStream.range(0, n).mapToObj(i -> letter + i).toList();
    }

    private static double[] row(SplittableRandom random, int n) {
        double[] p = new double[n];
        double sum = 0;
        for (int i = 0; i < n; i++) {
            p[i] = random.nextInt(4) == 0 && i < n - 1 ? 0 : random.nextDouble();
            sum += p[i];
        }
        for (int i = 0; i < n; i++) {
            p[i] /= sum;
        }
        return p;
    }
}
