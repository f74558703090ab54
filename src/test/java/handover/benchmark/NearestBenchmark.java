package handover.benchmark;

import handover.belief.HandoverBelief;
import handover.domain.HandoverDomain;
import handover.domain.Task;
import handover.io.DomainFiles;
import handover.math.SeededRandom;
import handover.math.Simplex;
import handover.math.Streams;
import handover.solver.BeliefMetric;
import handover.solver.BeliefSpace;
import handover.solver.Deadline;
import handover.solver.Decision;
import handover.solver.NearestPolicy;
import handover.solver.Policy;
import handover.solver.PolicyTable;
import handover.solver.Qmdp;
import java.util.concurrent.TimeUnit;
import java.util.random.RandomGenerator;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;

/** The nearest stored beliefs of a table: beliefs drawn uniformly, which lie farther apart than those of episodes. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
public class NearestBenchmark {
    private static final int QUERIES = 1024;
    private static final int NEIGHBOURS = 8;

    @Param({"1000", "100000"})
    public int stored;

    private final SeededRandom random = new SeededRandom();
    private final HandoverBelief[] queries = new HandoverBelief[QUERIES];
    private Policy policy;
    private int next;

    @Setup
    public void prepare() {
        HandoverDomain domain = DomainFiles.load("bowls-and-spoons");
        RandomGenerator chance = Streams.of(1, "jmh", stored);
        Policy teacher = new Qmdp().solve(domain, chance);
        BeliefSpace space = new BeliefSpace(BeliefMetric.DEFAULT);
        PolicyTable.Builder table = new PolicyTable.Builder(BeliefMetric.DEFAULT, stored);
        for (int k = 0; k < stored; k++) {
            HandoverBelief belief = belief(domain, chance);
            table.add(space.stored(belief, teacher.decide(belief, Deadline.NONE, chance)));
        }
        for (int k = 0; k < QUERIES; k++) {
            queries[k] = belief(domain, chance);
        }
        policy = new NearestPolicy(table.build(), NEIGHBOURS, Double.POSITIVE_INFINITY, teacher, teacher.toString());
    }

    private static HandoverBelief belief(HandoverDomain domain, RandomGenerator chance) {
        Task start = domain.task(domain.start());
        return HandoverBelief.of(start, point(domain.start().size(), chance), point(domain.start().size(), chance));
    }

    /** Uniform on the simplex. */
    private static double[] point(int n, RandomGenerator chance) {
        double[] p = new double[n];
        for (int i = 0; i < n; i++) {
            p[i] = chance.nextExponential();
        }
        Simplex.normalise(p, n);
        return p;
    }

    @Benchmark
    public Decision lookup() {
        next = (next + 1) % QUERIES;
        return policy.decide(queries[next], Deadline.NONE, random);
    }
}
