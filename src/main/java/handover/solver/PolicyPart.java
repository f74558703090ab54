package handover.solver;

/**
 * The stored beliefs of one {@link BeliefPart}, in the order of their tree. Immutable, thread safe; arrays must not be modified.
 */
public final class PolicyPart {
    private final BeliefPart part;
    private final int acts;
    private final float[] coordinates;
    private final float[] values;
    private final int[] choices;
    private final int[] ordinals;
    private final PointTree tree;

    /**
     * @param acts how many acts are on offer
     * @param coordinates 2n for each row, rows in the order of {@link PointTree#order}; not copied
     * @param values {@code acts} for each row, NaN where there is no estimate; not copied
     * @param choices index of the act that was chosen, by row; not copied
     * @param ordinals the position of each row in the order in which beliefs were met, over all parts; not copied
     */
    public PolicyPart(BeliefPart part, int acts, float[] coordinates, float[] values, int[] choices, int[] ordinals) {
        this.part = part;
        this.acts = acts;
        this.coordinates = coordinates;
        this.values = values;
        this.choices = choices;
        this.ordinals = ordinals;
        this.tree = new PointTree(coordinates, part.dimensions());
        if (tree.size() != choices.length || choices.length != ordinals.length || values.length != acts * choices.length) {
            throw new IllegalArgumentException("expected arrays for the same number of beliefs");
        }
    }

    public BeliefPart part() {
        return part;
    }

    public int size() {
        return choices.length;
    }

    public int acts() {
        return acts;
    }

    public float[] coordinates() {
        return coordinates;
    }

    public float[] values() {
        return values;
    }

    public int[] choices() {
        return choices;
    }

    public int[] ordinals() {
        return ordinals;
    }

    PointTree tree() {
        return tree;
    }
}
