package handover.io;

import handover.domain.HandoverDomain;
import handover.solver.NearestPolicy;
import handover.solver.Policy;
import handover.solver.Solver;
import handover.solver.Solvers;
import java.math.BigDecimal;
import java.nio.file.Path;
import java.util.random.RandomGenerator;

/**
 * Decides as a policy file says, see {@link NearestPolicy}; on the command line {@code nearest:FILE}.
 *
 * @param file made by {@code handover precompute} for the domain that is to be solved
 * @param k how many neighbours vote, at least 1
 * @param radius beyond which stored beliefs do not count, in the file's metric; may be infinite
 * @param fallback decides where the file does not; null for the teacher that the file names
 */
public record Nearest(Path file, int k, double radius, Solver fallback) implements Solver {
    /** How many neighbours vote unless told otherwise. */
    public static final int NEIGHBOURS = 8;
    /** Radius unless told otherwise. */
    public static final double RADIUS = 0.1;

    @Override
    public String name() {
        return "nearest:" + file + (k == NEIGHBOURS ? "" : ",k=" + k)
                + (radius == RADIUS ? "" : ",radius=" + (Double.isInfinite(radius) ? "inf" : BigDecimal.valueOf(radius).stripTrailingZeros().toPlainString()))
                + (fallback == null ? "" : ",fallback=" + fallback.name());
    }

    /**
     * Reads the file.
     *
     * @throws PolicyFileException if it cannot be used for this domain
     */
    @Override
    public Policy solve(HandoverDomain domain, RandomGenerator random) {
        PolicyFile policy = PolicyFile.read(file, domain.spec());
        Solver otherwise = fallback == null ? Solvers.parse(policy.run().teacher()) : fallback;
        return new NearestPolicy(policy.table(), k, radius, otherwise.solve(domain, random), otherwise.name());
    }
}
