package handover.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.Observation;
import handover.domain.PickSignal;
import handover.io.DomainFiles;
import handover.solver.Decision;
import handover.solver.Policy;
import handover.solver.Replan;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;

/** A policy is asked only while there is something to decide. */
class PlannerTest {
    private static final long MINUTE = 60_000_000_000L;

    private final HandoverBelief start = HandoverBelief.initial(DomainFiles.load("bowls-and-spoons"));
    private final Snapshot before = new Snapshot(1, 1, 1, start, true, 0);
    private final Snapshot after = before.with(start.after(Act.of("PICK", "metal_bowl")).given(new Observation(null, null, PickSignal.ACCEPTED)));
    private final AtomicReference<Snapshot> newest = new AtomicReference<>(before);
    private final AtomicInteger asked = new AtomicInteger();

    private Planner.Plan plan(Policy policy) throws InterruptedException {
        BlockingQueue<Planner.Plan> plans = new ArrayBlockingQueue<>(1);
        try (Planner planner = new Planner(policy, Replan.DEFAULT, newest::get, System::nanoTime, plans::add)) {
            assertTrue(planner.start(planner.job(0, MINUTE)));
            return plans.poll(30, TimeUnit.SECONDS);
        }
    }

    @Test
    void aTaskThatIsDoneIsNotPlannedFor() throws InterruptedException {
        assertFalse(before.over());
        assertTrue(after.over());
        newest.set(after);
        Planner.Plan plan = plan((belief, deadline, random) -> {
            asked.incrementAndGet();
            return Decision.of(Act.WAIT);
        });
        assertEquals(0, asked.get());
        assertSame(after, plan.at());
        assertNull(plan.decision());
        assertNull(plan.failure());
    }

    @Test
    void aTaskThatIsDoneMeanwhileIsNotPlannedForAgain() throws InterruptedException {
        Planner.Plan plan = plan((belief, deadline, random) -> {
            asked.incrementAndGet();
            newest.set(after);
            return Decision.of(Act.WAIT);
        });
        assertEquals(1, asked.get());
        assertSame(before, plan.at());
        assertEquals(Act.WAIT, plan.decision().act());
    }
}
