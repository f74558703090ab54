package handover.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import burlap.mdp.singleagent.model.TransitionProb;
import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.ActModel;
import handover.domain.DomainSpec;
import handover.domain.HandoverDomain;
import handover.domain.HandoverModel;
import handover.domain.HandoverState;
import handover.domain.IncrementalPickDomain;
import handover.domain.PickParameters;
import handover.domain.Rewards;
import handover.domain.Task;
import handover.domain.WrongPick;
import handover.io.DomainFiles;
import handover.math.MatchScore;
import handover.math.Simplex;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** QMDP against value iteration over what is wanted and what is known, by the BURLAP model alone; and what it does. */
class QmdpTest {
    private static final double GAMMA = 0.95;

    private static DomainSpec spec(Consumer<DomainSpec.Fields> change) {
        return SmallHandover.spec().with(s -> {
            s.rewards = new Rewards(50, -150, -2, 1, MatchScore.NONE, GAMMA);
            change.accept(s);
        });
    }

    static Stream<Arguments> domains() {
        return Stream.of(
                Arguments.of("base", new HandoverDomain(spec(s -> {}))),
                Arguments.of("terminal", new HandoverDomain(spec(s -> s.wrongPick = WrongPick.TERMINAL))),
                Arguments.of("two handovers", new HandoverDomain(spec(s -> s.handovers = 2))),
                Arguments.of("a wish that moves", new HandoverDomain(spec(s -> s.tau = 0.8))),
                Arguments.of("not worth it", new HandoverDomain(spec(s ->
                        s.rewards = new Rewards(-30, -150, -2, 1, MatchScore.NONE, GAMMA)))),
                Arguments.of("increments", new IncrementalPickDomain(spec(s -> {}))),
                Arguments.of("increments that stall", new IncrementalPickDomain(spec(s -> s.pick = new PickParameters(3, 0.7)))),
                Arguments.of("increments that stall, a wish that moves", new IncrementalPickDomain(spec(s -> {
                    s.pick = new PickParameters(2, 0.7);
                    s.tau = 0.9;
                }))));
    }

    /** The value of each act if everything is known from the next act on; without match rewards h plays no part. */
    private static final class ValueIteration {
        private final HandoverModel model;
        private final Map<Integer, Map<Task, Double>> values = new HashMap<>();

        ValueIteration(HandoverDomain domain, List<HandoverState> from) {
            model = new HandoverModel(domain, null);
            from.forEach(this::add);
            for (int k = 0; k < 700; k++) {
                values.forEach((wanted, tasks) -> tasks.replaceAll((task, v) -> task.done() ? 0.0
                        : task.legalActs().stream().mapToDouble(a -> q(state(wanted, task), a.act())).max().orElseThrow()));
            }
        }

        private static HandoverState state(int wanted, Task task) {
            return new HandoverState(wanted, task, Simplex.uniform(task.scene().size()));
        }

        private void add(HandoverState s) {
            if (values.computeIfAbsent(s.wanted(), w -> new HashMap<>()).putIfAbsent(s.task(), 0.0) == null && !s.task().done()) {
                for (ActModel a : s.task().legalActs()) {
                    model.transitions(state(s.wanted(), s.task()), a.act()).forEach(t -> add((HandoverState) t.eo.op));
                }
            }
        }

        double q(HandoverState s, Act act) {
            double sum = 0;
            for (TransitionProb t : model.transitions(s, act)) {
                HandoverState next = (HandoverState) t.eo.op;
                sum += t.p * (t.eo.r + GAMMA * values.get(next.wanted()).get(next.task()));
            }
            return sum;
        }
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("domains")
    void agreesWithValueIteration(String what, HandoverDomain domain) {
        Task start = domain.task(domain.start());
        Act pick = Act.of("PICK", "can");
        Task reaching = HandoverBelief.of(start, Simplex.uniform(2), Simplex.uniform(2)).after(pick).task();
        ValueIteration oracle = new ValueIteration(domain, List.of(ValueIteration.state(0, start), ValueIteration.state(1, start)));
        Policy policy = new Qmdp().solve(domain, new SplittableRandom(1));
        List<Task> tasks = domain.pickRule().increments() > 1 ? List.of(start, reaching) : List.of(start);
        for (Task task : tasks) {
            for (double p : new double[] {0, 0.3, 0.5, 0.9, 1}) {
                HandoverBelief belief = HandoverBelief.of(task, new double[] {p, 1 - p}, Simplex.uniform(2));
                Decision decision = policy.decide(belief, Deadline.NONE, new SplittableRandom(1));
                assertEquals(task.legalActs().size(), decision.values().size());
                for (ActModel a : task.legalActs()) {
                    double expected = p * oracle.q(ValueIteration.state(0, task), a.act())
                            + (1 - p) * oracle.q(ValueIteration.state(1, task), a.act());
                    assertEquals(expected, decision.values().get(a.act()), 1e-6, a + " at " + task + ", p = " + p);
                }
                double best = decision.values().values().stream().mapToDouble(v -> v).max().orElseThrow();
                assertEquals(best, decision.values().get(decision.act()), 0);
            }
        }
    }

    /** With the match reward: one step by the search's reward, then one step of a sure pick, by hand. */
    @Test
    void theMatchRewardIsPaidOnEveryStep() {
        HandoverDomain domain = new HandoverDomain(SmallHandover.spec());
        double[] b = {0.6, 0.4};
        double[] h = {0.7, 0.3};
        Decision decision = new Qmdp().solve(domain, new SplittableRandom(1))
                .decide(HandoverBelief.of(domain.task(domain.start()), b, h), Deadline.NONE, new SplittableRandom(1));
        for (ActModel a : domain.start().acts()) {
            if (!a.isPick()) {
                double[] after = domain.understood(a, h);
                double told = 0;
                for (int i = 0; i < 2; i++) {
                    ActModel pick = domain.start().model(Act.of("PICK", i == 0 ? "cup" : "can"));
                    double match = domain.matchReward(Simplex.vertex(2, i), domain.understood(pick, after), 2);
                    told += b[i] * (-1 + match + 50);
                }
                double expected = domain.actReward(domain.task(domain.start()), a) + domain.matchReward(b, after, 2) + GAMMA * told;
                assertEquals(expected, decision.values().get(a.act()), 1e-9, a.toString());
            }
        }
    }

    /** Where learning costs more than waiting, it never pays to learn for one who expects to be told. */
    @Test
    void itNeverAsks() {
        HandoverDomain domain = new HandoverDomain(DomainFiles.read("bowls-and-spoons").with(s ->
                s.rewards = new Rewards(50, -150, -2, 1, MatchScore.NONE, GAMMA)));
        Policy policy = new Qmdp().solve(domain, new SplittableRandom(1));
        Task start = domain.task(domain.start());
        for (double p = 0.25; p <= 1; p += 0.05) {
            double rest = (1 - p) / 3;
            Act act = policy.decide(HandoverBelief.of(start, new double[] {p, rest, rest, rest}, Simplex.uniform(4)), Deadline.NONE,
                    new SplittableRandom(1)).act();
            assertTrue(act.verb().equals("WAIT") || act.verb().equals("PICK"), act.toString());
        }
    }

    @Test
    void aDeadlineEndsTheComparison() {
        HandoverDomain domain = SmallHandover.domain();
        Decision decision = new Qmdp().solve(domain, new SplittableRandom(1))
                .decide(HandoverBelief.initial(domain), () -> true, new SplittableRandom(1));
        assertEquals(1, decision.values().size());
        assertTrue(!decision.finished());
    }
}
