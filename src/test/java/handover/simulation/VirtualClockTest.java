package handover.simulation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;

/** Everything happens once, in order, and time never runs backwards. */
class VirtualClockTest {
    private record Planned(double time, int number) {}

    /** Events that cause further events, some of them at once; what happened is what was planned, sorted stably. */
    @Property
    void eventsHappenInOrder(@ForAll Random random) {
        VirtualClock clock = new VirtualClock();
        List<Planned> planned = new ArrayList<>();
        List<Planned> happened = new ArrayList<>();
        for (int k = 0; k < 10; k++) {
            plan(clock, random, planned, happened);
        }
        double before = 0;
        int events = 0;
        while (clock.advance()) {
            assertTrue(clock.now() >= before, clock.now() + " after " + before);
            assertTrue(happened.size() > events, "time passes only from event to event");
            before = clock.now();
            events = happened.size();
        }
        List<Planned> sorted = new ArrayList<>(planned);
        sorted.sort(Comparator.comparingDouble(Planned::time));
        assertEquals(sorted, happened);
    }

    private static void plan(VirtualClock clock, Random random, List<Planned> planned, List<Planned> happened) {
        Planned event = new Planned(clock.now() + random.nextInt(4) / 2.0, planned.size());
        planned.add(event);
        clock.at(event.time, () -> {
            assertEquals(event.time, clock.now());
            happened.add(event);
            if (planned.size() < 200 && random.nextBoolean()) {
                plan(clock, random, planned, happened);
                plan(clock, random, planned, happened);
            }
        });
    }

    @Test
    void goesOnToATime() {
        VirtualClock clock = new VirtualClock();
        List<Double> happened = new ArrayList<>();
        clock.at(1, () -> {
            happened.add(clock.now());
            clock.at(2, () -> happened.add(clock.now()));
        });
        clock.at(2.5, () -> happened.add(clock.now()));
        clock.advanceTo(2);
        assertEquals(List.of(1.0, 2.0), happened);
        clock.advanceTo(2.25);
        assertEquals(2.25, clock.now());
        clock.advanceTo(1);
        assertEquals(2.25, clock.now(), "never back");
        assertTrue(clock.advance());
        assertEquals(List.of(1.0, 2.0, 2.5), happened);
    }

    @Test
    void thePastIsRefused() {
        VirtualClock clock = new VirtualClock();
        assertFalse(clock.advance());
        clock.at(2, () -> {});
        assertTrue(clock.advance());
        clock.at(2, () -> {});
        for (double time : new double[] {1.9, Double.NaN, Double.POSITIVE_INFINITY}) {
            assertEquals("expected a time of at least 2.0 s, got " + time,
                    assertThrows(IllegalArgumentException.class, () -> clock.at(time, () -> {})).getMessage());
        }
    }
}
