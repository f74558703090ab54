package handover.math;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;

class Vector3Test {
    private static final Vector3 X = new Vector3(1, 0, 0);
    private static final Vector3 Y = new Vector3(0, 1, 0);
    private static final Vector3 Z = new Vector3(0, 0, 1);

    @Test
    void axes() {
        assertEquals(Z, X.cross(Y));
        assertEquals(X, Y.cross(Z));
        assertEquals(Math.PI / 2, X.angleTo(Y), 1e-15);
        assertEquals(Math.PI, X.angleTo(X.times(-3)), 1e-15);
        assertEquals(0, X.angleTo(X.times(3)), 0);
        assertEquals(5, new Vector3(3, 0, -4).norm(), 1e-15);
        assertEquals(new Vector3(1, 1, -2), X.plus(Y).minus(Z.times(2)));
        assertTrue(Double.isNaN(new Vector3(0, 0, 0).unit().x()), "the zero vector has no direction");
    }

    @Test
    void smallAnglesAreAccurate() {
        for (double t : new double[] {1e-3, 1e-6, 1e-9, 1e-12}) {
            assertEquals(1, X.angleTo(new Vector3(Math.cos(t), Math.sin(t), 0)) / t, 1e-9, "angle " + t);
        }
    }

    @Property(tries = 200, seed = "21")
    void productsAndAngles(@ForAll Random random) {
        Vector3 a = any(random);
        Vector3 b = any(random);
        Vector3 c = a.cross(b);
        assertEquals(0, c.dot(a), 1e-12, "a x b is across a");
        assertEquals(0, c.dot(b), 1e-12, "a x b is across b");
        assertEquals(a.norm() * b.norm() * Math.sin(a.angleTo(b)), c.norm(), 1e-12, "|a x b|");
        assertEquals(a.norm() * b.norm() * Math.cos(a.angleTo(b)), a.dot(b), 1e-12, "a . b");
        assertEquals(a.angleTo(b), b.angleTo(a), 1e-15, "symmetry");
        assertEquals(1, a.unit().norm(), 1e-14, "unit");
    }

    private static Vector3 any(Random random) {
        return new Vector3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
    }
}
