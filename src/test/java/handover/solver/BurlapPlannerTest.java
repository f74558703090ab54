package handover.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import burlap.behavior.singleagent.Episode;
import burlap.behavior.singleagent.pomdp.BeliefPolicyAgent;
import burlap.debugtools.RandomFactory;
import burlap.mdp.singleagent.pomdp.PODomain;
import burlap.mdp.singleagent.pomdp.SimulatedPOEnvironment;
import handover.belief.HandoverBelief;
import handover.belief.HandoverBeliefUpdate;
import handover.domain.Act;
import handover.domain.HandoverDomain;
import handover.domain.Observation;
import handover.domain.PickSignal;
import handover.io.DomainFiles;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** BURLAP's own agent in BURLAP's own environment plays our domain with our planner. */
class BurlapPlannerTest {
    private final HandoverDomain handover = new HandoverDomain(DomainFiles.read("bowls-and-spoons"));

    private Episode play(String wanted, Solver solver, long seed) {
        RandomFactory.seedMapped(0, seed);
        PODomain domain = handover.generateDomain();
        SimulatedPOEnvironment environment = new SimulatedPOEnvironment(domain, handover.initialState(wanted));
        BurlapPlanner planner = new BurlapPlanner(handover, domain, solver, new SplittableRandom(seed));
        HandoverBelief start = HandoverBelief.initial(handover);
        BeliefPolicyAgent agent = new BeliefPolicyAgent(domain, environment, planner.planFromState(start));
        agent.setUpdater(new HandoverBeliefUpdate());
        agent.setBeliefState(start);
        return agent.actUntilTerminalOrMaxSteps(60);
    }

    @ParameterizedTest
    @ValueSource(strings = {"metal_bowl", "color_bowl", "plastic_spoon", "silver_spoon"})
    void burlapsAgentHandsOverWhatIsWanted(String wanted) {
        Episode episode = play(wanted, new Poss(2, 10, true), 5);
        int last = episode.maxTimeStep();
        Observation seen = (Observation) episode.state(last);
        assertEquals(PickSignal.ACCEPTED, seen.signal(), episode.actionSequence.toString());
        assertEquals(Act.of("PICK", wanted), episode.action(last - 1));
        assertTrue(episode.reward(last) > 40, "reward " + episode.reward(last));
        assertEquals(episode.actionSequence, play(wanted, new Poss(2, 10, true), 5).actionSequence);
    }

    @ParameterizedTest
    @ValueSource(strings = {"confirm", "poss"})
    void greedyActIsThePolicysAct(String name) {
        Solver solver = name.equals("confirm") ? new Confirm() : new Poss(2, 5, true);
        PODomain domain = handover.generateDomain(new SplittableRandom(1));
        BurlapPlanner planner = new BurlapPlanner(handover, domain, solver, new SplittableRandom(3));
        HandoverBelief belief = HandoverBelief.initial(handover);
        Decision decision = solver.solve(handover, null).decide(belief, Deadline.NONE, new SplittableRandom(3));
        assertEquals(decision.act(), planner.policy().action(belief));
        assertEquals(List.of(), domain.getActionTypes().stream().filter(t -> t.allApplicableActions(belief).isEmpty()).toList());
        assertSame(belief, belief.copy());
    }
}
