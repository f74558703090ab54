package handover.contract;

import handover.domain.CommunicatedParameters;
import handover.domain.HandoverDomain;
import handover.domain.PerceptionParameters;
import handover.domain.PickParameters;
import handover.domain.SpeechParameters;
import handover.io.DomainFiles;
import handover.math.MatchScore;
import java.util.List;
import org.junit.jupiter.api.Nested;

/** Every shipped variant under the contract. */
class ShippedVariantsTest {
    private static final PerceptionParameters ALL_MINDS = new PerceptionParameters(0.1, 0.1, 100_000);

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

    /** As many minds as there may be: the filter is then exact (rule 15); what fifty lose is tested in NestedFilterTest. */
    @Nested
    class NestedBelief extends DomainContract {
        @Override
        protected HandoverDomain domain() {
            return DomainFiles.domain(DomainFiles.read("bowls-nested").with(s -> s.perception = ALL_MINDS));
        }
    }

    /** Surprise, contrast and increments depend on what was perceived. */
    @Nested
    class NestedIncremental extends DomainContract {
        @Override
        protected HandoverDomain domain() {
            return DomainFiles.domain(DomainFiles.read("bowls-incremental").with(s -> {
                s.perception = ALL_MINDS;
                s.pick = new PickParameters(2, 0.7);
                s.speech = new SpeechParameters(0.2, 0.05, 0.5, 0.3, 0.01, List.of(0.5, 0.3, 0.2));
            }));
        }
    }

    @Nested
    class NestedCommunicated extends DomainContract {
        @Override
        protected HandoverDomain domain() {
            return DomainFiles.domain(DomainFiles.read("bowls-communicated").with(s -> {
                s.perception = ALL_MINDS;
                s.tau = 0.9;
                s.objects = s.objects.subList(0, 3);
            }));
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
