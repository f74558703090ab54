package handover.benchmark;

import handover.belief.HandoverBelief;
import handover.domain.ActModel;
import handover.domain.HandoverDomain;
import handover.domain.HandoverObservationFunction;
import handover.domain.HandoverState;
import handover.io.DomainFiles;
import handover.math.SeededRandom;
import handover.math.Streams;
import handover.solver.Deadline;
import handover.solver.Decision;
import handover.solver.Policy;
import handover.solver.Poss;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.random.RandomGenerator;
import org.openjdk.jmh.annotations.AuxCounters;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;

/**
 * POSS, H=2 and C=10, without what a decision costs besides its search: {@code nodes} are beliefs visited in a millisecond, each of which
 * stands for a sampled observation, its posterior, and the values of all acts there.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
public class SearchBenchmark {
    private static final int BELIEFS = 64;

    /** Objects on a generated table. */
    @Param({"6", "20"})
    public int objects;

    @Param({"base", "incremental"})
    public String variant;

    private final SeededRandom random = new SeededRandom();
    private final List<HandoverBelief> beliefs = new ArrayList<>();
    private Policy policy;
    private int next;

    /** Beliefs visited, reported for each unit of time. */
    @AuxCounters
    @State(Scope.Thread)
    public static class Visited {
        public long nodes;

        /** Starts again from 0. */
        @Setup(Level.Iteration)
        public void reset() {
            nodes = 0;
        }
    }

    /** Beliefs after a few acts at random that are no picks. */
    @Setup
    public void prepare() {
        HandoverDomain domain = DomainFiles.load("generated-" + objects + "-" + variant);
        RandomGenerator chance = Streams.of(1, "jmh", objects);
        HandoverObservationFunction senses = new HandoverObservationFunction(domain, chance);
        List<ActModel> quiet = domain.start().acts().stream().filter(a -> !a.isPick()).toList();
        policy = new Poss(2, 10, true).solve(domain, chance);
        beliefs.clear();
        while (beliefs.size() < BELIEFS) {
            HandoverBelief b = HandoverBelief.initial(domain);
            int wanted = chance.nextInt(objects);
            for (int steps = chance.nextInt(4); steps > 0; steps--) {
                ActModel act = quiet.get(chance.nextInt(quiet.size()));
                b = b.after(act.act());
                b = b.given(senses.sample(new HandoverState(wanted, b.task(), b.human()), act.act()));
            }
            beliefs.add(b);
        }
    }

    @Benchmark
    public Decision decide(Visited visited) {
        next = (next + 1) % BELIEFS;
        random.seed(next);
        Decision decision = policy.decide(beliefs.get(next), Deadline.NONE, random);
        visited.nodes += decision.nodes();
        return decision;
    }
}
