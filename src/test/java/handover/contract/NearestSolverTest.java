package handover.contract;

import static org.junit.jupiter.api.Assertions.assertEquals;

import handover.cli.Main;
import handover.io.Nearest;
import handover.solver.Solver;
import handover.solver.Solvers;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Precomputed policies under the contract, on the domain that each is for. */
class NearestSolverTest {
    @TempDir
    static Path folder;

    @BeforeAll
    static void make() {
        for (String domain : List.of("bowls-and-spoons", "bowls-incremental")) {
            PrintStream nowhere = new PrintStream(OutputStream.nullOutputStream());
            assertEquals(0, Main.run(new String[] {"precompute", domain, "--teacher", "poss:H=1,C=1", "--beliefs", "300", "--out",
                folder.resolve(domain).toString()}, InputStream.nullInputStream(), nowhere, nowhere));
        }
    }

    /** A policy file for one domain. */
    private abstract static class Precomputed extends SolverContract {
        private final String domain;

        Precomputed(String domain) {
            this.domain = domain;
        }

        @Override
        protected Solver solver() {
            return new Nearest(folder.resolve(domain), 4, 0.2, null);
        }

        @Override
        protected List<String> domains() {
            return List.of(domain);
        }

        @Test
        void itIsFoundUnderItsName() {
            assertEquals(solver(), Solvers.parse(solver().name()));
        }
    }

    @Nested
    class Base extends Precomputed {
        Base() {
            super("bowls-and-spoons");
        }
    }

    @Nested
    class Incremental extends Precomputed {
        Incremental() {
            super("bowls-incremental");
        }
    }
}
