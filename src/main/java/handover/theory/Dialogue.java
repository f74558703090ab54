package handover.theory;

import handover.math.Simplex;
import java.util.ArrayList;
import java.util.List;
import java.util.random.RandomGenerator;

/**
 * What a robot did, and what may have been perceived of it. Immutable, thread safe.
 *
 * @param chosen the object that it meant
 * @param transition how the human thinks that its choice moves
 * @param acts one perception per act
 */
public record Dialogue(int chosen, Transition<Agent.Robot> transition, List<Perception<Agent.Robot>> acts) {
    private static final double WIDTH = 1.2;

    public Dialogue {
        acts = List.copyOf(acts);
    }

    /** One drawn from {@code random} (advanced). */
    public static Dialogue random(DialogueSettings s, RandomGenerator random) {
        int n = s.objects();
        double sigma = s.narrowest() * Math.pow(s.widest() / s.narrowest(), random.nextDouble());
        double[] angle = random.doubles(n, 0, WIDTH).toArray();
        double[][] lambda = new double[n][n];
        for (int i = 0; i < n; i++) {
            double[] p = new double[n];
            for (int a = 0; a < n; a++) {
                double t = (angle[a] - angle[i]) / sigma;
                p[a] = Math.exp(-t * t / 2);
            }
            Simplex.normalise(p, n);
            for (int a = 0; a < n; a++) {
                lambda[a][i] = p[a];
            }
        }
        return drawn(s, lambda, random);
    }

    private static Dialogue drawn(DialogueSettings s, double[][] lambda, RandomGenerator random) {
        int n = s.objects();
        List<Message<Agent.Robot>> messages = new ArrayList<>();
        for (double[] l : lambda) {
            messages.add(new Message<>(l));
        }
        int chosen = random.nextInt(n);
        List<Perception<Agent.Robot>> acts = new ArrayList<>();
        for (int k = 0; k < s.acts(); k++) {
            double[] p = new double[n];
            for (int a = 0; a < n; a++) {
                p[a] = lambda[a][chosen];
            }
            acts.add(Perception.confused(messages, Simplex.sample(p, n, random), s.attention(), s.confusion()));
        }
        return new Dialogue(chosen, Transition.stay(n, s.stay()), acts);
    }

    /** B after all the acts. */
    public Nested<Agent.Robot> follow(Nested<Agent.Robot> start) {
        Nested<Agent.Robot> now = start;
        for (Perception<Agent.Robot> act : acts) {
            now = now.updated(transition, act);
        }
        return now;
    }
}
