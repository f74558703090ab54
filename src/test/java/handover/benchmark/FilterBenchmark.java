package handover.benchmark;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.ActModel;
import handover.domain.HandoverDomain;
import handover.domain.HandoverObservationFunction;
import handover.domain.HandoverState;
import handover.domain.Observation;
import handover.io.DomainFiles;
import handover.math.Simplex;
import handover.math.Streams;
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

/** The exact filter, what people understand, and what they say and show. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
public class FilterBenchmark {
    /** Objects on a generated table. */
    @Param({"6", "20", "100"})
    public int objects;

    private HandoverDomain domain;
    private HandoverBelief belief;
    private HandoverBelief predicted;
    private HandoverState state;
    private HandoverObservationFunction senses;
    private Observation observation;
    private ActModel ask;
    private double[] human;
    private double[] understood;

    /** The robot asks; the person answers with words and a gesture. */
    @Setup
    public void prepare() {
        domain = DomainFiles.load("generated-" + objects);
        RandomGenerator random = Streams.of(1, "jmh", objects);
        String wanted = domain.start().objects().get(0).name();
        ask = domain.start().model(Act.of("ASK", domain.start().objects().get(1).name()));
        senses = new HandoverObservationFunction(domain, random);
        belief = HandoverBelief.initial(domain);
        predicted = belief.after(ask.act());
        state = new HandoverState(domain.start().indexOf(wanted), predicted.task(), predicted.human());
        do {
            observation = senses.sample(state, ask.act());
        } while (observation.speech() == null || !observation.speech().mayHaveContent() || observation.gesture() == null);
        human = Simplex.uniform(objects);
        understood = new double[objects];
    }

    @Benchmark
    public HandoverBelief wholeStep() {
        return belief.after(ask.act()).given(observation);
    }

    @Benchmark
    public HandoverBelief act() {
        return belief.after(ask.act());
    }

    @Benchmark
    public HandoverBelief utterance() {
        return predicted.heard(observation.speech());
    }

    @Benchmark
    public HandoverBelief gesture() {
        return predicted.saw(observation.gesture());
    }

    @Benchmark
    public HandoverBelief silence() {
        return predicted.closed();
    }

    @Benchmark
    public double[] understanding() {
        domain.understand(ask, human, understood, objects);
        return understood;
    }

    @Benchmark
    public Object observation() {
        return senses.sample(state, ask.act());
    }
}
