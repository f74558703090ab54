package handover.domain;

import burlap.mdp.singleagent.pomdp.PODomain;
import handover.math.MatchScore;
import handover.math.Simplex;
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
    public double matchBound() {
        return weight * score.max();
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

    /** A pair in which the human expects anything alike, see {@link #initialState}. */
    public CommunicatedState initialPair(String wanted, RandomGenerator random) {
        return CommunicatedState.draw(initialState(wanted), random);
    }
}
