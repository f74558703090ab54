package handover.bridge;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;

import handover.domain.HandoverDomain;
import handover.io.DomainFiles;
import handover.io.Messages;
import java.nio.charset.StandardCharsets;
import java.util.SplittableRandom;
import java.util.function.IntToDoubleFunction;
import org.junit.jupiter.api.Test;

/** The clock of the bridge's machine jumps; the beliefs are those of a clock that does not. */
class ClockJumpTest {
    private static final double NOW = 1.8e9;
    private static final String[] EPISODE = {
        "{'v':1,'type':'begin'}", "{'v':1,'type':'speech','text':'silver'}",
        "{'v':1,'type':'acted','act':'ASK','objects':['silver_spoon'],'status':'started'}", "{'v':1,'type':'speech','text':'no'}",
        "{'v':1,'type':'acted','act':'ASK','objects':['silver_spoon'],'status':'completed'}",
        "{'v':1,'type':'acted','act':'POINT','objects':['metal_bowl'],'status':'started'}",
        "{'v':1,'type':'gesture','hand':[0.05,0.9,0.15],'shoulder':[0.15,1.4,0.35]}", "{'v':1,'type':'speech','text':'yes, the large one'}"};

    @Test
    void beliefsDoNotDependOnTheClock() {
        Snapshot steady = play(k -> NOW + k);
        SplittableRandom chance = new SplittableRandom(1);
        for (int trial = 0; trial < 200; trial++) {
            double[] times = chance.doubles(EPISODE.length, NOW - 1e6, NOW + 1e6).toArray();
            assertSame(steady, play(k -> times[k]));
        }
        assertSame(steady, play(k -> NOW - 3600 * k));
        assertSame(steady, play(k -> NOW));
        assertSame(steady, play(k -> k == 3 ? 0 : NOW + k));
    }

    private static Snapshot play(IntToDoubleFunction clock) {
        HandoverDomain domain = DomainFiles.load("bowls-and-spoons");
        Session session = Session.of(domain, 1, 2);
        for (int k = 0; k < EPISODE.length; k++) {
            session.apply(Messages.decode(EPISODE[k].replace('\'', '"').getBytes(StandardCharsets.UTF_8)), clock.applyAsDouble(k),
                    Session.Journal.NONE);
        }
        return session.now();
    }

    private static void assertSame(Snapshot expected, Snapshot got) {
        assertArrayEquals(expected.belief().probabilities(), got.belief().probabilities());
        assertArrayEquals(expected.belief().human(), got.belief().human());
    }
}
