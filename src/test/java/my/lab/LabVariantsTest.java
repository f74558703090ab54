package my.lab;

import handover.contract.DomainContract;
import handover.domain.HandoverDomain;
import handover.io.DomainFiles;
import org.junit.jupiter.api.Nested;

/** What a user writes to put variants of their own under the toolkit's contract: three lines each. */
class LabVariantsTest {
    @Nested
    class Quiet extends DomainContract {
        @Override
        protected HandoverDomain domain() {
            return DomainFiles.load("src/test/resources/my/lab/quiet.json");
        }
    }

    @Nested
    class Fickle extends DomainContract {
        @Override
        protected HandoverDomain domain() {
            return DomainFiles.load("src/test/resources/my/lab/fickle.json");
        }
    }

    @Nested
    class HoldUp extends DomainContract {
        @Override
        protected HandoverDomain domain() {
            return DomainFiles.load("src/test/resources/my/lab/hold-up.json");
        }
    }
}
