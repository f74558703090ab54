package handover.simulation;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.ActModel;
import handover.domain.DomainSpec;
import handover.domain.HandoverDomain;
import handover.domain.Observation;
import handover.domain.PickParameters;
import handover.domain.PickSignal;
import handover.domain.Speech;
import handover.domain.WrongPick;
import handover.io.DomainFiles;
import handover.math.Simplex;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.SplittableRandom;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.LongRange;
import org.junit.jupiter.api.Test;

/** Evidence counts for the act of its time, whenever it arrives. */
class TimedFilterTest {
    private static final List<DomainSpec> SPECS = List.of(DomainFiles.read("bowls-and-spoons").with(s -> s.handovers = 3),
            DomainFiles.read("kitchen-20").with(s -> s.wrongPick = WrongPick.REMOVED),
            DomainFiles.read("bowls-incremental").with(s -> {
                s.pick = new PickParameters(2, 0.6);
                s.tau = 0.9;
            }));

    /**
     * Random acts and people. What arrives in the step in which it was said, what arrives at any later time, in any order, and
     * the filter of whole steps give the same belief.
     */
    @Property(tries = 300)
    void lateIsAsGoodAsInTime(@ForAll Random random, @ForAll @LongRange(min = 0, max = 1_000_000) long seed) {
        HandoverDomain domain = DomainFiles.domain(SPECS.get(random.nextInt(SPECS.size())));
        World world = new World(domain, seed, 0);
        HandoverBelief whole = HandoverBelief.initial(domain);
        TimedFilter inTime = new TimedFilter(whole);
        TimedFilter late = new TimedFilter(whole);
        List<Arrival> held = new ArrayList<>();
        for (int step = 0; step < 6 && !whole.task().done(); step++) {
            List<ActModel> legal = whole.task().legalActs();
            Act act = legal.get(random.nextInt(legal.size())).act();
            world.step(act);
            Observation o = world.react(act);
            whole = whole.after(act).given(o);
            boolean completes = o.signal() == PickSignal.ACCEPTED || o.signal() == PickSignal.REJECTED;
            List<Arrival> arrivals = ResponseTimes.NONE.arrivals(step, domain.start().acts().get(0), 0.5, completes, o, new SplittableRandom(0))
                    .stream().map(a -> new Arrival(a.at() + 0.6, a.arrives() + 0.6, a.speech(), a.gesture())).toList();
            for (TimedFilter filter : List.of(inTime, late)) {
                filter.started(step, act);
                filter.ended(step + 0.5, o.signal());
            }
            arrivals.forEach(inTime::sensed);
            held.addAll(arrivals);
            if (random.nextBoolean()) {
                Collections.shuffle(held, random);
                held.forEach(late::sensed);
                held.clear();
            }
        }
        Collections.shuffle(held, random);
        held.forEach(late::sensed);
        assertArrayEquals(whole.probabilities(), inTime.settled().probabilities(), 0);
        assertEquals(whole.task(), inTime.settled().task());
        // Speech and gesture of one step may be weighed in the other order, which rounds in another way.
        assertArrayEquals(whole.probabilities(), late.settled().probabilities(), 1e-9);
        assertArrayEquals(whole.human(), late.settled().human(), 1e-12);
        assertEquals(whole.task(), late.settled().task());
        assertEquals(inTime.version(), late.version(), "every change is a version");
    }

    @Test
    void aLateNoIsAboutTheQuestionOfItsTime() {
        HandoverDomain domain = DomainFiles.load("bowls-and-spoons");
        Act first = Act.of("ASK", "metal_bowl");
        Act second = Act.of("ASK", "silver_spoon");
        Speech no = Speech.of("no", domain.vocabulary());
        TimedFilter filter = new TimedFilter(HandoverBelief.initial(domain));
        filter.started(0, first);
        filter.started(2.5, second);
        assertArrayEquals(Simplex.uniform(4), filter.now().probabilities(), 1e-12);
        filter.sensed(new Arrival(2.4, 2.6, no, null));
        HandoverBelief expected = HandoverBelief.initial(domain).after(first).heard(no).after(second);
        assertArrayEquals(expected.probabilities(), filter.now().probabilities());
        assertEquals(second, filter.now().task().openReference(), "the second question is still open");
        filter.sensed(new Arrival(2.5, 2.7, no, null));
        assertArrayEquals(expected.heard(no).probabilities(), filter.now().probabilities());
        assertEquals(null, filter.now().task().openReference(), "now it is answered");
        assertEquals(4, filter.version());
    }

    @Test
    void beforeTheFirstActThereIsNoStepToClose() {
        HandoverBelief start = HandoverBelief.initial(DomainFiles.load("bowls-incremental"));
        TimedFilter filter = new TimedFilter(start);
        assertSame(start, filter.settled());
        filter.started(0, Act.of("PICK", "metal_bowl"));
        assertArrayEquals(filter.now().closed().probabilities(), filter.settled().probabilities());
        filter.ended(1, PickSignal.MOVING);
        assertEquals(1, filter.version(), "an increment that surely advances tells nothing");
    }
}
