package handover.math;

/** A point or direction in metres (table frame: x right, y away from the robot, z up). Immutable. */
public record Vector3(double x, double y, double z) {

    public Vector3 minus(Vector3 o) {
        return new Vector3(x - o.x, y - o.y, z - o.z);
    }

    public Vector3 plus(Vector3 o) {
        return new Vector3(x + o.x, y + o.y, z + o.z);
    }

    public Vector3 times(double s) {
        return new Vector3(s * x, s * y, s * z);
    }

    public double dot(Vector3 o) {
        return x * o.x + y * o.y + z * o.z;
    }

    public Vector3 cross(Vector3 o) {
        return new Vector3(y * o.z - z * o.y, z * o.x - x * o.z, x * o.y - y * o.x);
    }

    public double norm() {
        return Math.sqrt(dot(this));
    }

    /** The unit vector in this direction; NaN components if this is the zero vector. */
    public Vector3 unit() {
        return times(1 / norm());
    }

    /** The angle to {@code o} in radians, in [0, pi]; accurate for small angles too, unlike the arc cosine. */
    public double angleTo(Vector3 o) {
        return Math.atan2(cross(o).norm(), dot(o));
    }

    /** {@code [x, y, z]}. */
    @Override
    public String toString() {
        return "[" + x + ", " + y + ", " + z + "]";
    }
}
