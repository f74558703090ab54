package handover.solver;

import java.util.stream.IntStream;

/**
 * A way to swap objects that leaves the problem as it is. Arrays must not be modified.
 *
 * @param objects object i becomes object {@code objects[i]}
 * @param acts act a becomes act {@code acts[a]}
 */
record Symmetry(int[] objects, int[] acts) {

    static Symmetry identity(int objects, int acts) {
        return new Symmetry(IntStream.range(0, objects).toArray(), IntStream.range(0, acts).toArray());
    }
}
