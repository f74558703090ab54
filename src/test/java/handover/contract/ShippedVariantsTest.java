package handover.contract;

import handover.domain.CommunicatedParameters;
import handover.domain.HandoverDomain;
import handover.domain.PickParameters;
import handover.io.DomainFiles;
import handover.math.MatchScore;
import org.junit.jupiter.api.Nested;

/** Every shipped variant under the contract. */
class ShippedVariantsTest {
    @Nested
    class Base extends DomainContract {
        @Override
        protected HandoverDomain domain() {
            return DomainFiles.load("bowls-and-spoons");
        }
    }

    @Nested
    class SixObjectsSeveralHandovers extends DomainContract {
        @Override
        protected HandoverDomain domain() {
            return DomainFiles.domain(DomainFiles.read("table-line-6").with(s -> s.handovers = 3));
        }
    }

    @Nested
    class Incremental extends DomainContract {
        @Override
        protected HandoverDomain domain() {
            return DomainFiles.load("bowls-incremental");
        }
    }

    @Nested
    class UnsureIncrements extends DomainContract {
        @Override
        protected HandoverDomain domain() {
            return DomainFiles.domain(DomainFiles.read("bowls-incremental")
                    .with(s -> s.pick = new PickParameters(2, 0.7)));
        }
    }

    @Nested
    class Communicated extends DomainContract {
        @Override
        protected HandoverDomain domain() {
            return DomainFiles.load("bowls-communicated");
        }
    }

    @Nested
    class IncrementalCommunicated extends DomainContract {
        @Override
        protected HandoverDomain domain() {
            return DomainFiles.load("bowls-incremental-communicated");
        }
    }

    @Nested
    class CommunicatedLog extends DomainContract {
        @Override
        protected HandoverDomain domain() {
            return DomainFiles.domain(DomainFiles.read("bowls-communicated")
                    .with(s -> s.communicated = new CommunicatedParameters(2, MatchScore.LOG)));
        }
    }
}
