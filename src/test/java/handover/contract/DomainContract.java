package handover.contract;

import handover.domain.HandoverDomain;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

/**
 * Everything that a variant must keep. A variant is put under it by three lines:
 *
 * <pre>{@code
 * class ChattyDomainTest extends DomainContract {
 *     protected HandoverDomain domain() { return DomainFiles.load("my-domain.json"); }
 * }
 * }</pre>
 *
 * Each rule of {@link Rules} is a test; a failure names the rule and the state and act that broke it.
 */
public abstract class DomainContract {
    /** The variant, on a domain of a few objects. */
    protected abstract HandoverDomain domain();

    @TestFactory
    Stream<DynamicTest> keeps() {
        return Rules.ALL.stream().map(rule -> DynamicTest.dynamicTest(rule.toString(), () -> rule.check(domain())));
    }
}
