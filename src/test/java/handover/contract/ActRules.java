package handover.contract;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import burlap.mdp.core.action.Action;
import burlap.mdp.core.action.ActionType;
import handover.domain.Act;
import handover.domain.ActEffect;
import handover.domain.ActModel;
import handover.domain.ActType;
import handover.domain.Answer;
import handover.domain.HandoverState;
import handover.domain.Scene;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;

/** Rules about acts and how people take them. */
final class ActRules {
    private static final double ROUNDING = 1e-9;

    private ActRules() {}

    static void legal(Walk walk) {
        for (Walk.Visit v : walk.visits()) {
            List<Action> acts = walk.legal(v.state());
            assertFalse(acts.isEmpty(), "no act " + v);
            assertEquals(acts.size(), new HashSet<>(acts).size(), "repeated acts " + v);
            HandoverState s = Walk.base(v.state());
            for (int i = 0; i < s.human().length; i++) {
                assertEquals(acts, walk.legal(new HandoverState(i, s.task(), s.human())), "other acts if something else is wanted, " + v);
            }
            assertEquals(acts, walk.legal(v.state()), "other acts when asked again, " + v);
        }
    }

    static void values(Walk walk) {
        List<Action> acts = walk.legal(walk.start());
        for (Action a : acts) {
            Act act = (Act) a;
            assertEquals(act, act.copy(), "copy of " + act);
            assertEquals(act.hashCode(), new Act(act.verb(), act.objects()).hashCode(), "hash of " + act);
            ActionType type = walk.burlap.getAction(act.actionName());
            assertTrue(type != null, "no action type named " + act.actionName());
            assertEquals(act, type.associatedAction(String.join(",", act.objects())), "read back " + act);
        }
    }

    static void lambda(Walk walk) {
        Scene scene = walk.domain.start();
        Map<ActType, double[]> sums = new HashMap<>();
        for (ActModel m : scene.acts()) {
            assertEquals(scene.size(), m.lambda().length, "entries of lambda of " + m);
            double[] sum = sums.computeIfAbsent(m.type(), t -> new double[scene.size()]);
            for (int i = 0; i < sum.length; i++) {
                assertTrue(m.lambda()[i] >= 0, "lambda(" + m + " | " + name(scene, i) + ") = " + m.lambda()[i]);
                sum[i] += m.lambda()[i];
            }
        }
        sums.forEach((type, sum) -> {
            for (int i = 0; i < sum.length; i++) {
                assertEquals(1, sum[i], ROUNDING, "sum of lambda(" + type.verb() + " | " + name(scene, i) + ")");
            }
        });
    }

    static void understanding(Walk walk) {
        for (Walk.Visit v : walk.visits()) {
            HandoverState s = Walk.base(v.state());
            for (ActModel m : s.task().legalActs()) {
                double[] before = s.human().clone();
                double[] after = walk.domain.understood(m, s.human());
                double sum = 0;
                for (double h : after) {
                    assertTrue(h >= 0 && h <= 1 + ROUNDING, "h = " + h + " after " + m + ", " + v);
                    sum += h;
                }
                assertEquals(1, sum, ROUNDING, "sum of h after " + m + ", " + v);
                assertArrayEquals(before, s.human(), 0, "h was modified by " + m);
            }
        }
    }

    static void replies(Walk walk) {
        for (Walk.Visit v : walk.visits()) {
            HandoverState s = Walk.base(v.state());
            for (ActModel m : s.task().legalActs()) {
                for (double h : new double[] {0, 0.3, 1}) {
                    probability(walk.domain.contentRate(m.type(), h), "P(content words) after " + m + " with h = " + h);
                }
                ActEffect effect = s.task().effect(m.act());
                for (int i = 0; i < s.human().length; i++) {
                    double sum = 0;
                    for (Answer answer : Answer.values()) {
                        double p = effect.answers(answer)[i];
                        probability(p, "P(" + answer + " | " + name(s.task().scene(), i) + ") after " + m);
                        sum += p;
                    }
                    assertEquals(1, sum, ROUNDING, "sum of answers for " + name(s.task().scene(), i) + " after " + m);
                    if (m.match() != null) {
                        probability(m.match()[i], "match of " + m + " with " + name(s.task().scene(), i));
                    }
                }
            }
        }
    }

    private static void probability(double p, String what) {
        assertTrue(p >= -ROUNDING && p <= 1 + ROUNDING, what + " = " + p);
    }

    private static String name(Scene scene, int i) {
        return scene.objects().get(i).name();
    }
}
