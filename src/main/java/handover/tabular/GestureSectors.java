package handover.tabular;

import handover.domain.Gesture;
import handover.domain.HumanModel;
import handover.domain.Scene;
import handover.math.Vector3;

/**
 * Gestures as the object that they point at most nearly: sector j is all directions from the shoulder of the domain file whose angle
 * to object j is the smallest. Immutable, thread safe.
 */
final class GestureSectors {
    private static final int FINE_RINGS = 300;
    private static final int COARSE_RINGS = 100;
    private static final int AZIMUTHS = 720;
    /** Rings are fine up to so many standard deviations from what is meant. */
    private static final double NEAR = 6;

    private final Scene scene;
    private final Vector3[] arms;
    /** By meant object, sector. */
    private final double[][] probability;
    private final double[] mass;

    GestureSectors(Scene scene) {
        this.scene = scene;
        Vector3 shoulder = scene.domain().spec().shoulder();
        arms = scene.objects().stream().map(o -> o.position().minus(shoulder).unit()).toArray(Vector3[]::new);
        probability = new double[arms.length][arms.length];
        mass = new double[arms.length];
        for (int i = 0; i < arms.length; i++) {
            integrate(i);
        }
    }

    /** P(a gesture falls into sector {@code j}, given that object {@code i} is meant and there is a gesture). */
    double probability(int i, int j) {
        return probability[i][j];
    }

    /** What the quadrature gives for the whole sphere before it is scaled to 1. */
    double mass(int i) {
        return mass[i];
    }

    /** The sector of a direction; the first of those that are as near. */
    int sector(Vector3 direction) {
        int nearest = 0;
        double most = Double.NEGATIVE_INFINITY;
        for (int j = 0; j < arms.length; j++) {
            double c = direction.dot(arms[j]);
            if (c > most) {
                most = c;
                nearest = j;
            }
        }
        return nearest;
    }

    /** Rings around the direction to what is meant: the density is the same all along a ring. */
    private void integrate(int i) {
        Vector3 axis = arms[i];
        Vector3 u = axis.cross(Math.abs(axis.z()) < 0.9 ? new Vector3(0, 0, 1) : new Vector3(1, 0, 0)).unit();
        Vector3 w = axis.cross(u);
        double near = Math.min(Math.PI, NEAR * Math.sqrt(scene.domain().spec().gesture().variance()));
        for (int k = 0; k < FINE_RINGS + COARSE_RINGS; k++) {
            double low = k < FINE_RINGS ? near * k / FINE_RINGS : near + (Math.PI - near) * (k - FINE_RINGS) / COARSE_RINGS;
            double high = k < FINE_RINGS ? near * (k + 1) / FINE_RINGS : near + (Math.PI - near) * (k + 1 - FINE_RINGS) / COARSE_RINGS;
            if (high > low) {
                addRing(i, axis, u, w, (low + high) / 2, 2 * Math.PI * (Math.cos(low) - Math.cos(high)));
            }
        }
        for (int j = 0; j < arms.length; j++) {
            mass[i] += probability[i][j];
        }
        for (int j = 0; j < arms.length; j++) {
            probability[i][j] /= mass[i];
        }
    }

    private void addRing(int i, Vector3 axis, Vector3 u, Vector3 w, double t, double steradians) {
        Vector3 along = axis.times(Math.cos(t));
        Gesture gesture = new Gesture(scene.domain().spec().shoulder(), along.plus(u.times(Math.sin(t))));
        double each = HumanModel.gestureDensities(scene, gesture)[i] * steradians / AZIMUTHS;
        for (int k = 0; k < AZIMUTHS; k++) {
            double azimuth = 2 * Math.PI * (k + 0.5) / AZIMUTHS;
            Vector3 d = along.plus(u.times(Math.sin(t) * Math.cos(azimuth))).plus(w.times(Math.sin(t) * Math.sin(azimuth)));
            probability[i][sector(d)] += each;
        }
    }
}
