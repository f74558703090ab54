package handover.theory;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.theory.Agent.Human;
import handover.theory.Agent.Robot;
import java.io.IOException;
import java.net.URI;
import java.nio.file.Path;
import java.util.List;
import java.util.SplittableRandom;
import javax.tools.DiagnosticCollector;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileObject;
import javax.tools.SimpleJavaFileObject;
import javax.tools.StandardJavaFileManager;
import javax.tools.StandardLocation;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Two agents that take turns half a step apart, and that levels cannot be mixed up. */
class MindTest {
    private static final int N = 4;
    private static final double C = 0.3;

    /** Ten steps of both, against the three levels written out by hand; everybody perceives everything. */
    @Test
    void twoAgentsTakeTurns() {
        SplittableRandom random = new SplittableRandom(10);
        Transition<Robot> robotMoves = Transition.stay(N, 0.95);
        Transition<Human> humanMoves = Transition.stay(N, 0.9);
        Mind<Robot, Human> robot = new Mind<>(Moment.robot(0), new Choice<>(uniform()), Categorical.uniform(N),
                Atoms.certain(Categorical.uniform(N)));
        Mind<Human, Robot> human = new Mind<>(Moment.human(0), new Choice<>(uniform()), Categorical.uniform(N),
                Atoms.certain(Categorical.uniform(N)));
        double[] b = uniform();
        double[] beta = uniform();
        double[] own = uniform();
        for (int t = 0; t < 10; t++) {
            Message<Robot> said = RandomTheory.message(N, random);
            robot = robot.acts(robotMoves, Perception.exact(said));
            human = t == 0 ? new Mind<>(human.now(), human.own(), human.belief().updated(robotMoves, said), human.nested())
                    : human.hears(Moment.robot(t), robotMoves, said, null, 0);
            beta = bayes(beta, 0.95, said.likelihood());
            Message<Human> answered = RandomTheory.message(N, random);
            human = human.acts(humanMoves, Perception.exact(answered));
            robot = robot.hears(Moment.human(t), humanMoves, answered, null, C);
            b = bayes(b, 0.9, answered.likelihood());
            own = complied(own, answered.likelihood());
            assertArrayEquals(beta, human.belief().probabilities(), 1e-12);
            assertArrayEquals(beta, robot.nested().mean(), 1e-12, "the robot knows what the human believes");
            assertArrayEquals(b, robot.belief().probabilities(), 1e-12);
            assertArrayEquals(b, human.nested().mean(), 1e-12);
            assertArrayEquals(own, robot.own().probabilities(), 1e-12);
            assertEquals(Moment.robot(t + 1), robot.now());
        }
    }

    private static double[] uniform() {
        return new double[] {0.25, 0.25, 0.25, 0.25};
    }

    private static double[] bayes(double[] p, double stay, double[] l) {
        double[] next = new double[N];
        double z = 0;
        for (int i = 0; i < N; i++) {
            for (int j = 0; j < N; j++) {
                next[i] += l[i] * (i == j ? stay : (1 - stay) / (N - 1)) * p[j];
            }
            z += next[i];
        }
        for (int i = 0; i < N; i++) {
            next[i] /= z;
        }
        return next;
    }

    private static double[] complied(double[] p, double[] l) {
        double sum = l[0] + l[1] + l[2] + l[3];
        double[] next = new double[N];
        for (int i = 0; i < N; i++) {
            next[i] = (1 - C) * p[i] + C * l[i] / sum;
        }
        return next;
    }

    @Test
    void evidenceMovesTheNestedBelief() {
        Nested<Robot> nested = DirichletBelief.of(new double[] {1, 2, 5}, Projection.MOMENTS);
        Mind<Robot, Human> robot = new Mind<>(Moment.robot(0), new Choice<>(new double[] {1, 0, 0}),
                Categorical.uniform(3), nested);
        Mind<Robot, Human> next = robot.hears(Moment.human(0), Transition.stay(3, 1), Message.nothing(3),
                new Evidence<>(new double[] {0, 1, 0}), 0);
        assertArrayEquals(new double[] {1 / 9.0, 3 / 9.0, 5 / 9.0}, next.nested().mean(), 1e-12);
        assertArrayEquals(robot.own().probabilities(), next.own().probabilities());
    }

    @Test
    void nobodyActsOutOfTurn() {
        Mind<Robot, Human> robot = new Mind<>(Moment.robot(2), new Choice<>(uniform()), Categorical.uniform(N),
                Atoms.certain(Categorical.uniform(N)));
        assertThrows(IllegalArgumentException.class, () -> robot.hears(Moment.human(1), Transition.stay(N, 1),
                Message.nothing(N), null, 0));
        assertThrows(IllegalArgumentException.class, () -> new Mind<>(Moment.robot(0), new Choice<Robot>(uniform()),
                Categorical.<Human>uniform(3), Atoms.certain(Categorical.<Robot>uniform(N))));
        assertEquals("2.5", Moment.human(2).toString());
    }

    /** What mixes up whose level is meant does not compile; the same statement with one mark changed does. */
    @Test
    void levelsCannotBeMixedUp(@TempDir Path out) throws IOException {
        assertTrue(compiles("Categorical<Robot> f(Categorical<Robot> x, Message<Robot> a) { return x.given(a); }", out));
        assertFalse(compiles("Categorical<Robot> f(Categorical<Robot> x, Message<Human> a) { return x.given(a); }", out));
        assertFalse(compiles("Object f(Nested<Robot> x, Perception<Human> a) { return x.perceived(a); }", out));
        assertFalse(compiles("Object f(Categorical<Human> x, Transition<Robot> t) { return x.predicted(t); }", out));
        assertTrue(compiles("Transition<Robot> f(Message<Human> a) { return Transition.compliance(0.5, a); }", out));
        assertFalse(compiles("Transition<Robot> f(Message<Robot> a) { return Transition.compliance(0.5, a); }", out));
        assertTrue(compiles("Object f(Mind<Robot, Human> m, Transition<Human> t, Message<Human> a) {"
                + " return m.hears(Moment.human(0), t, a, null, 0); }", out));
        assertFalse(compiles("Object f(Mind<Robot, Human> m, Transition<Human> t, Message<Human> a) {"
                + " return m.hears(Moment.robot(0), t, a, null, 0); }", out));
    }

    private static boolean compiles(String method, Path out) throws IOException {
        String code = "package handover.theory; import handover.theory.Agent.*; abstract class Snippet { " + method + " }";
        JavaFileObject source = new SimpleJavaFileObject(URI.create("string:///handover/theory/Snippet.java"),
                JavaFileObject.Kind.SOURCE) {
            @Override
            public CharSequence getCharContent(boolean ignoreEncodingErrors) {
                return code;
            }
        };
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        try (StandardJavaFileManager files = compiler.getStandardFileManager(null, null, null)) {
            files.setLocationFromPaths(StandardLocation.CLASS_OUTPUT, List.of(out));
            String path = System.getProperty("java.class.path");
            return compiler.getTask(null, files, new DiagnosticCollector<>(), List.of("-classpath", path), null,
                    List.of(source)).call();
        }
    }
}
