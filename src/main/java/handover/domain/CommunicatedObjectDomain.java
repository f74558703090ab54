package handover.domain;

import burlap.mdp.core.state.State;
import burlap.mdp.singleagent.pomdp.PODomain;
import handover.math.MatchScore;
import handover.math.Simplex;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.random.RandomGenerator;

/**
 * The variant with the hidden pair &lt;omega_R, omega_H&gt; (MODEL 7): omega_H is the object that the human expects, drawn
 * from h' after each act, and the robot is paid when it is the one that they want. To filter and search this is the base
 * domain with another match reward, the expectation 3 sum_i b(i) h'(i); {@link #generateDomain} states it over pairs.
 * Immutable, thread safe.
 *
 * <p>Source: "Progress Report: Social Feedback for Robotic Collaboration", section 2.3.
 */
public class CommunicatedObjectDomain extends HandoverDomain {
    private final MatchScore score;
    private final double weight;

    /** As {@link HandoverDomain#HandoverDomain}. */
    public CommunicatedObjectDomain(DomainSpec spec) {
        super(spec);
        this.score = spec.communicated().score();
        this.weight = spec.communicated().reward();
    }

    @Override
    public double matchReward(double[] b, double[] h, int n) {
        return weight * score.of(b, h, n);
    }

    @Override
    public double matchBound(double[] b, int n) {
        return weight * score.max(b, n);
    }

    @Override
    public boolean beliefDependentReward() {
        return false;
    }

    /** Paid when the human, who wants {@code wanted}, expects {@code expected}; not modified: h'. */
    double communicated(int wanted, int expected, double[] h) {
        if (score == MatchScore.LINEAR) {
            return wanted == expected ? weight : 0;
        }
        return matchReward(Simplex.vertex(h.length, wanted), h, h.length);
    }

    /** Over {@link CommunicatedState}s, with the reward of the pair itself. */
    @Override
    public PODomain generateDomain(RandomGenerator random) {
        PODomain domain = super.generateDomain(random);
        domain.setModel(new CommunicatedModel(this, random));
        return domain;
    }

    /** With each object that the human may expect. */
    @Override
    public Map<State, Double> hidden(HandoverState s) {
        Map<State, Double> pairs = new LinkedHashMap<>();
        for (int expected = 0; expected < s.human().length; expected++) {
            pairs.put(new CommunicatedState(s, expected), s.human()[expected]);
        }
        return pairs.isEmpty() ? Map.of(new CommunicatedState(s, -1), 1.0) : pairs;
    }
}
