package handover.contract;

import handover.domain.HandoverDomain;
import java.util.function.Consumer;

/**
 * One rule of the contract.
 *
 * @param number for reference
 * @param name what must hold
 * @param body throws an AssertionError, or anything else, where it does not
 */
public record Rule(int number, String name, Consumer<Walk> body) {

    /** Throws an AssertionError that names the rule if the domain breaks it. */
    public void check(HandoverDomain domain) {
        try {
            body.accept(new Walk(domain));
        } catch (AssertionError | RuntimeException e) {
            throw new AssertionError(this + ": " + e.getMessage(), e);
        }
    }

    @Override
    public String toString() {
        return "rule " + number + " (" + name + ")";
    }
}
