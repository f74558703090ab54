package handover.domain;

/**
 * How a pick goes on: after how many increments it completes, and how surely each of them advances. Held by any variant
 * that wants it. Immutable.
 *
 * @param increments K, at least 1
 * @param advance probability that an increment advances, above 0
 */
public record PickRule(int increments, double advance) {
    /** A pick completes at once. */
    public static final PickRule IMMEDIATE = new PickRule(1, 1);

    /** The report's incremental pick (MODEL 5). */
    public static PickRule incremental(PickParameters p) {
        return new PickRule(p.increments(), p.advance());
    }

    /** Expected discounted number of tries of one increment. */
    public double tries(double discount) {
        return 1 / (1 - discount * (1 - advance));
    }

    /** The discount that lies between the start of one increment and the start of the next. */
    public double perIncrement(double discount) {
        return discount * advance * tries(discount);
    }

    /** The discount that lies between the start of an increment and the moment at which it advances. */
    public double onAdvance(double discount) {
        return advance * tries(discount);
    }
}
