package handover.simulation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.domain.Act;
import handover.domain.DomainSpec;
import handover.domain.HandoverDomain;
import handover.domain.Observation;
import handover.domain.PickSignal;
import handover.domain.Speech;
import handover.io.DomainFiles;
import handover.solver.Deadline;
import handover.solver.Poss;
import handover.solver.Solver;
import handover.solver.Threshold;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What is counted as a cancel, by hand; and that increments prevent wrong picks. */
class ReachesTest {
    private static final HandoverDomain DOMAIN = DomainFiles.load("bowls-incremental");

    private static Step step(String act, String said, PickSignal signal) {
        Act a = act.equals("WAIT") ? Act.WAIT : Act.of("PICK", act);
        Speech speech = said == null ? null : Speech.of(said, DOMAIN.vocabulary());
        return new Step(a, new Observation(speech, null, signal), 0, null);
    }

    private static Reaches reaches(boolean success, Step... steps) {
        Measures measures = new Measures(success, true, 0, steps.length, 0, 0, 0, 0, 0);
        return Reaches.of(new Episode(0, "x", "metal_bowl", null, List.of(steps), measures, new long[0]));
    }

    @Test
    void countsCancelsByWhatWasReachedFor() {
        Reaches r = reaches(true, step("color_bowl", null, PickSignal.MOVING), step("color_bowl", "no", PickSignal.MOVING),
                step("WAIT", "metal", PickSignal.NONE), step("metal_bowl", null, PickSignal.MOVING),
                step("WAIT", null, PickSignal.NONE), step("metal_bowl", null, PickSignal.MOVING),
                step("metal_bowl", null, PickSignal.MOVING), step("metal_bowl", null, PickSignal.ACCEPTED));
        assertEquals(new Reaches(false, 1, 1, 1, List.of(new Reaches.Heeded(1, 2))), r);
    }

    @Test
    void anObjectionThatIsNotHeededHasNoDelay() {
        Reaches r = reaches(false, step("color_bowl", "no", PickSignal.MOVING), step("color_bowl", "no", PickSignal.MOVING),
                step("color_bowl", null, PickSignal.REJECTED), step("metal_bowl", null, PickSignal.MOVING));
        assertEquals(new Reaches(true, 0, 0, 1, List.of()), r);
    }

    @Test
    void aLateCancelIsCountedFromTheFirstNo() {
        Reaches r = reaches(true, step("color_bowl", "no", PickSignal.MOVING), step("color_bowl", "no", PickSignal.MOVING),
                step("metal_bowl", null, PickSignal.MOVING));
        assertEquals(List.of(2), r.stepsToCancel());
        assertEquals(List.of(new Reaches.Heeded(0, 2)), r.heeded());
    }

    private static Estimate wrong(HandoverDomain domain, Solver solver) throws InterruptedException {
        List<Episode> played = new ArrayList<>();
        Episodes.play(new EpisodeRunner(domain, domain, solver, 1, 100, () -> Deadline.NONE, () -> 0), 0, 1000, 2, played::add);
        int count = (int) played.stream().filter(e -> Reaches.of(e).wrong()).count();
        return Estimate.share(count, played.size());
    }

    /** The seeds are fixed; over seeds the odds that the intervals of 0% and 3% of 1,000 overlap are below 1e-3. */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void incrementsLowerWrongPicksWithIntervalsApart(boolean planner) throws InterruptedException {
        Solver solver = planner ? new Poss(2, 10, true) : new Threshold(0.9);
        HandoverDomain base = DomainFiles.domain(DOMAIN.spec().with(s -> s.variant = DomainSpec.BASE));
        Estimate with = wrong(DOMAIN, solver);
        Estimate without = wrong(base, solver);
        assertTrue(with.high() < without.low(), with + " against " + without);
    }
}
