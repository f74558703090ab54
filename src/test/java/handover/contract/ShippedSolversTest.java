package handover.contract;

import handover.solver.Anytime;
import handover.solver.BurlapSparseSampling;
import handover.solver.Clairvoyant;
import handover.solver.Confirm;
import handover.solver.Greedy;
import handover.solver.Heuristic;
import handover.solver.Poss;
import handover.solver.Qmdp;
import handover.solver.RandomActs;
import handover.solver.Solver;
import handover.solver.Threshold;
import my.lab.AskOnce;
import org.junit.jupiter.api.Nested;

/** Every shipped solver, and the README's, under the contract. */
class ShippedSolversTest {
    @Nested
    class PossThree extends SolverContract {
        @Override
        protected Solver solver() {
            return new Poss(3, 2, true);
        }
    }

    @Nested
    class PossWithoutLeaves extends SolverContract {
        @Override
        protected Solver solver() {
            return new Poss(2, 3, false);
        }
    }

    @Nested
    class Raced extends SolverContract {
        @Override
        protected Solver solver() {
            return new Anytime(3, 8);
        }
    }

    @Nested
    class Burlap extends SolverContract {
        @Override
        protected Solver solver() {
            return new BurlapSparseSampling(1, 2);
        }
    }

    @Nested
    class NoFeedback extends SolverContract {
        @Override
        protected Solver solver() {
            return new Threshold(0.9);
        }
    }

    @Nested
    class FixedFeedback extends SolverContract {
        @Override
        protected Solver solver() {
            return new Confirm();
        }
    }

    @Nested
    class RuleOfThumb extends SolverContract {
        @Override
        protected Solver solver() {
            return new Heuristic();
        }
    }

    @Nested
    class GreedyCommunicator extends SolverContract {
        @Override
        protected Solver solver() {
            return new Greedy();
        }
    }

    @Nested
    class KnownAfterOneStep extends SolverContract {
        @Override
        protected Solver solver() {
            return new Qmdp();
        }
    }

    @Nested
    class Floor extends SolverContract {
        @Override
        protected Solver solver() {
            return new RandomActs();
        }
    }

    @Nested
    class Ceiling extends SolverContract {
        @Override
        protected Solver solver() {
            return new Clairvoyant();
        }
    }

    @Nested
    class FromTheReadme extends SolverContract {
        @Override
        protected Solver solver() {
            return new AskOnce();
        }
    }
}
