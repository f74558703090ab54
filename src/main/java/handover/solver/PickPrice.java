package handover.solver;

import handover.domain.PickRule;

/** What reaching for an object until the pick completes comes to. */
final class PickPrice {
    private PickPrice() {}

    /** Expected discounted number of increments that are paid for. */
    static double prices(PickRule rule, double discount) {
        double sum = 0;
        double weight = 1;
        for (int k = 0; k < rule.increments(); k++) {
            sum += weight * rule.tries(discount);
            weight *= rule.perIncrement(discount);
        }
        return sum;
    }

    /** The discount of the outcome. */
    static double outcome(PickRule rule, double discount) {
        return Math.pow(rule.perIncrement(discount), rule.increments() - 1) * rule.onAdvance(discount);
    }
}
