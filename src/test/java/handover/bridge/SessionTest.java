package handover.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.domain.DomainSpec;
import handover.domain.Frame;
import handover.domain.HandoverDomain;
import handover.domain.Scene;
import handover.domain.TableObject;
import handover.io.DomainFiles;
import handover.io.Messages;
import handover.io.WireCode;
import handover.io.WireException;
import handover.math.Vector3;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** When something was sensed, and where: the rules of docs/bridge.md about time, order and frames. */
class SessionTest {
    private static final DomainSpec SPEC = DomainFiles.read("table-line-6").with(s -> s.frames = Map.of("camera",
            new Frame(List.of(List.of(0.0, -1.0, 0.0), List.of(1.0, 0.0, 0.0), List.of(0.0, 0.0, 1.0)),
                    new Vector3(0.15, 1.4, 0.35))));
    private static final HandoverDomain DOMAIN = DomainFiles.domain(SPEC);

    private static final String ASK = "{'v':1,'type':'acted','act':'ASK','objects':['%s'],'status':'started'}";

    private final Session session = Session.of(DOMAIN, 1, 2);

    private Session.Outcome at(double arrival, String json) {
        return session.apply(Messages.decode(json.replace('\'', '"').getBytes(StandardCharsets.UTF_8)), arrival,
                Session.Journal.NONE);
    }

    private void waited(double received, double applied, String json) {
        session.apply(Messages.decode(json.replace('\'', '"').getBytes(StandardCharsets.UTF_8)), received, applied,
                Session.Journal.NONE);
    }

    private WireCode refused(double arrival, String json) {
        Snapshot before = session.now();
        WireCode code = assertThrows(WireException.class, () -> at(arrival, json)).code();
        assertSame(before, session.now());
        return code;
    }

    private double red() {
        return session.now().belief().probabilities()[1];
    }

    @Test
    void lateSpeechIsWeighedWhereItWasSaid() {
        at(100, "{'v':1,'type':'begin'}");
        at(101, "{'v':1,'type':'acted','act':'ASK','objects':['red_ball'],'status':'started','t':101}");
        at(103, "{'v':1,'type':'acted','act':'ASK','objects':['blue_ball'],'status':'started','t':103}");
        at(103.5, "{'v':1,'type':'speech','text':'yes','t':102.9}");
        double yes = red();
        assertTrue(yes > 0.9, "the yes was to the red ball: " + yes);
        at(103.6, "{'v':1,'type':'speech','text':'no','t':103.1}");
        assertTrue(red() > yes, "the no was to the blue ball: " + red());
        assertEquals(WireCode.STALE, refused(104, "{'v':1,'type':'speech','text':'no','t':101.9}"), "older than 2 s");
        assertEquals(WireCode.STALE, refused(104, "{'v':1,'type':'gesture','hand':[0,1,1],'shoulder':[0,0,1],'t':0}"));
        assertEquals(5, session.now().version());
    }

    /** What waits for its turn is as old as it was when it came, and is weighed where it was said. */
    @Test
    void whatHadToWaitIsWeighedWhereItCame() {
        at(100, "{'v':1,'type':'begin'}");
        at(101, ASK.formatted("red_ball"));
        at(103, ASK.formatted("blue_ball"));
        waited(102.9, 104.5, "{'v':1,'type':'speech','text':'yes'}");
        assertTrue(red() > 0.9, "the yes was to the red ball: " + red());
        double yes = red();
        waited(103.1, 109, "{'v':1,'type':'speech','text':'blue','t':102.5}");
        assertTrue(red() < yes, "it was 0.6 s old when it came: " + red());
        at(109.1, ASK.formatted("green_marker"));
        assertThrows(WireException.class, () -> waited(103.2, 109.2, "{'v':1,'type':'speech','text':'yes','t':102}"),
                "that step is forgotten");
        double no = red();
        waited(109.05, 109.3, "{'v':1,'type':'speech','text':'no'}");
        assertTrue(red() > no, "to the blue ball, the step of which is remembered: " + red());
    }

    @Test
    void theClockMayBeSetBackWhileSomethingWaits() {
        at(5000, "{'v':1,'type':'begin'}");
        at(5001, ASK.formatted("red_ball"));
        waited(5002, 1002, "{'v':1,'type':'speech','text':'yes'}");
        assertTrue(red() > 0.9);
        at(1003, ASK.formatted("blue_ball"));
        at(1004, "{'v':1,'type':'speech','text':'no','t':1003.5}");
        assertEquals(5, session.now().version());
    }

    @Test
    void nobodyIsAheadOfTheirTime() {
        at(100, "{'v':1,'type':'begin','t':200}");
        at(101, "{'v':1,'type':'acted','act':'ASK','objects':['red_ball'],'status':'started','t':1e10}");
        at(101.1, "{'v':1,'type':'speech','text':'yes','t':101.05}");
        assertTrue(red() > 0.9, "a robot whose clock is ahead does not make everything stale");
        at(101.2, "{'v':1,'type':'speech','text':'red','t':1e10}");
        assertEquals(4, session.now().version());
    }

    @Test
    void theClockMayBeSetBack() {
        at(5000, "{'v':1,'type':'begin'}");
        at(5001, "{'v':1,'type':'acted','act':'ASK','objects':['red_ball'],'status':'started'}");
        at(1001.5, "{'v':1,'type':'speech','text':'yes','t':1001.4}");
        assertTrue(red() > 0.9, "it is still about the question");
        at(1002, "{'v':1,'type':'acted','act':'ASK','objects':['blue_ball'],'status':'started'}");
        at(1002.1, "{'v':1,'type':'speech','text':'red','t':1001.9}");
        assertEquals(5, session.now().version());
    }

    @Test
    void whatWasSensedBeforeTheEpisodeIsStale() {
        at(100, "{'v':1,'type':'begin'}");
        assertEquals(WireCode.STALE, refused(100.5, "{'v':1,'type':'speech','text':'red','t':99.5}"));
        at(101, "{'v':1,'type':'end'}");
        assertEquals(WireCode.NO_EPISODE, refused(101, "{'v':1,'type':'speech','text':'red'}"));
        assertEquals(WireCode.NO_EPISODE, refused(101, "{'v':1,'type':'speech','text':'red','final':false}"));
    }

    @Test
    void framesOfTheDomainFileAreMapped() {
        at(100, "{'v':1,'type':'begin'}");
        at(100, "{'v':1,'type':'gesture','frame':'camera','shoulder':[0,0,0],'hand':[-0.5,-0.14,-0.26]}");
        double[] mapped = session.now().belief().probabilities();
        at(101, "{'v':1,'type':'begin'}");
        at(101, "{'v':1,'type':'gesture','shoulder':[0.15,1.4,0.35],'hand':[0.29,0.9,0.09]}");
        for (int i = 0; i < mapped.length; i++) {
            assertEquals(session.now().belief().probabilities()[i], mapped[i], 1e-12);
        }
        at(102, "{'v':1,'type':'scene','frame':'camera','objects':[{'name':'red_ball','position':[-0.7,0.1,-0.3]}]}");
        assertEquals(0, session.table().objects().get(1).position().minus(new Vector3(0.05, 0.7, 0.05)).norm(), 1e-12);
        assertEquals(WireCode.UNKNOWN_FRAME, refused(103,
                "{'v':1,'type':'scene','frame':'kinect','objects':[{'name':'red_ball','position':[0,1,0]}]}"));
    }

    @Test
    void ofTwoArmsTheOneThatPointsCounts() {
        String skeleton = "{'v':1,'type':'gesture','side':'%s','joints':{'SHOULDER_LEFT':[0.4,1.4,0.35],'HAND_LEFT':[0.4,1.4,-0.4],"
                + "'SHOULDER_RIGHT':[0.15,1.4,0.35],'HAND_RIGHT':[0.29,0.9,0.09]}}";
        at(100, "{'v':1,'type':'begin'}");
        at(100, skeleton.formatted("best"));
        double best = red();
        at(101, "{'v':1,'type':'begin'}");
        at(101, skeleton.formatted("right"));
        assertEquals(best, red());
        at(102, "{'v':1,'type':'begin'}");
        at(102, skeleton.formatted("left"));
        assertFalse(red() == best);
    }

    @Test
    void idsAreRememberedBySourceAndForgottenInTime() {
        at(100, "{'v':1,'type':'begin'}");
        assertTrue(at(100, "{'v':1,'type':'speech','text':'red','id':'1','source':'a'}").applied());
        for (int k = 0; k < 1000; k++) {
            at(100, "{'v':1,'type':'speech','text':'x','id':'" + k + "','source':'b'}");
        }
        assertFalse(at(100, "{'v':1,'type':'speech','text':'red','id':'1','source':'a'}").applied(), "b does not push a out");
        for (int k = 0; k < SeenIds.IDS; k++) {
            at(100, "{'v':1,'type':'speech','text':'x','id':'n" + k + "','source':'a'}");
        }
        assertTrue(at(100, "{'v':1,'type':'speech','text':'red','id':'1','source':'a'}").applied());
    }

    @Test
    void anIdIsForOneMessage() {
        at(100, "{'v':1,'type':'begin','id':'0'}");
        at(100, "{'v':1,'type':'speech','text':'red','id':'1'}");
        assertFalse(at(100, "{'v':1,'type':'speech','text':'red','id':'1','t':99.9}").applied(), "the same, sent again");
        assertFalse(at(100, "{'v':1,'type':'speech','text':'re','id':'1','final':false}").applied());
        for (String other : List.of("'speech','text':'blue'", "'gesture','hand':[0,0.5,0.1],'shoulder':[0,1,0]", "'end'",
                "'acted','act':'WAIT','status':'started'", "'scene','removed':['red_ball']", "'begin'")) {
            assertEquals(WireCode.BAD_FIELD, refused(100, "{'v':1,'id':'1','type':" + other + "}"), other);
        }
        assertEquals(WireCode.BAD_FIELD, refused(100, "{'v':1,'type':'begin','seed':5,'id':'0'}"));
        assertFalse(at(100, "{'v':1,'type':'begin','id':'0'}").applied());
        assertTrue(at(100, "{'v':1,'type':'speech','text':'blue','id':'1','source':'a'}").applied());
    }

    @Test
    void handedOverObjectsAreBackInTheNextEpisode() {
        at(100, "{'v':1,'type':'begin'}");
        at(101, "{'v':1,'type':'acted','act':'PICK','objects':['red_ball'],'status':'completed','pick':'accepted'}");
        at(102, "{'v':1,'type':'scene','objects':[{'name':'red_ball','position':[0,0.5,0]}]}");
        assertEquals(5, session.now().belief().scene().size(), "what is in the hand of the human is not on the table");
        at(103, "{'v':1,'type':'end'}");
        at(104, "{'v':1,'type':'begin'}");
        List<TableObject> objects = session.now().belief().scene().objects();
        assertEquals(new Vector3(0, 0.5, 0), objects.get(1).position());
        assertEquals(6, objects.size());
    }

    /** A tracker that still sees it in somebody's hand only moves it; who adds it says that it is on the table. */
    @Test
    void whatWasHandedOverComesBackWhenItIsAdded() {
        HandoverDomain two = DomainFiles.domain(DomainFiles.read("table-line-6").with(s -> s.handovers = 2));
        String ball = "{'name':'red_ball','position':[0,0.5,0],'words':{'red':1}}";
        for (String how : List.of("'added':[" + ball + "]", "'removed':['red_ball'],'added':[" + ball + "]")) {
            Session played = Session.of(two, 1, 2);
            String[] messages = {"{'v':1,'type':'begin'}",
                "{'v':1,'type':'acted','act':'PICK','objects':['red_ball'],'status':'completed','pick':'accepted'}",
                "{'v':1,'type':'scene','objects':[{'name':'red_ball','position':[0,0.4,0]}]}", "{'v':1,'type':'scene'," + how + "}"};
            int[] sizes = {6, 5, 5, 6};
            for (int k = 0; k < messages.length; k++) {
                played.apply(Messages.decode(messages[k].replace('\'', '"').getBytes(StandardCharsets.UTF_8)), 100 + k, Session.Journal.NONE);
                assertEquals(sizes[k], played.now().belief().scene().size(), messages[k]);
            }
            Scene there = played.now().belief().scene();
            assertEquals(new Vector3(0, 0.5, 0), there.objects().get(there.indexOf("red_ball")).position());
            assertEquals(there.objects(), played.table().objects());
            assertEquals(1.0 / 6, played.now().belief().probabilities()[there.indexOf("red_ball")], 1e-12);
            assertEquals(WireCode.BAD_FIELD, assertThrows(WireException.class, () -> played.apply(Messages.decode(
                    messages[3].replace("'removed':['red_ball'],", "").replace('\'', '"').getBytes(StandardCharsets.UTF_8)), 110,
                    Session.Journal.NONE)).code(), "it is there already");
        }
    }

    @Test
    void whatMovesTheBeliefIsNotUninformative() {
        at(100, "{'v':1,'type':'begin'}");
        assertTrue(at(100, "{'v':1,'type':'speech','text':'yes'}").remarks().uninformative(), "nothing was asked");
        double before = red();
        assertFalse(at(101, "{'v':1,'type':'speech','text':'no, the red ball'}").remarks().uninformative());
        assertTrue(red() > before + 0.1);
    }

    @Test
    void aJournalThatFailsKeepsTheBelief() {
        at(100, "{'v':1,'type':'begin'}");
        Snapshot before = session.now();
        assertThrows(IllegalStateException.class, () -> session.apply(Messages.decode(
                "{\"v\":1,\"type\":\"speech\",\"text\":\"red\",\"id\":\"1\"}".getBytes(StandardCharsets.UTF_8)), 101, outcome -> {
                    throw new IllegalStateException("the disk is full");
                }));
        assertSame(before, session.now());
        assertTrue(at(101, "{'v':1,'type':'speech','text':'red','id':'1'}").applied(), "and it may be sent again");
    }
}
