package handover.simulation;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.ActType;
import handover.domain.AskType;
import handover.domain.HandoverDomain;
import handover.domain.PickSignal;
import handover.math.MatchScore;
import handover.math.Simplex;

/** Adds up what an episode is worth. Used by one thread. */
final class Tally {
    private final HandoverDomain domain;
    private Boolean firstPickRight;
    private double seconds;
    private double discountedReturn;
    private double discount = 1;
    private int steps;
    private int questions;
    private double logScore;
    private double brierScore;
    private double distance;

    Tally(HandoverDomain domain) {
        this.domain = domain;
    }

    /** A belief at which it is decided what to do, and what is wanted then. */
    void score(HandoverBelief belief, int wanted) {
        double[] b = belief.probabilities();
        double[] truth = Simplex.vertex(b.length, wanted);
        logScore += MatchScore.LOG.of(truth, b, b.length);
        brierScore += MatchScore.BRIER.of(truth, b, b.length);
        distance += Simplex.l1(b, belief.human());
    }

    /** A step, and what became of it if it is a pick. */
    void add(Act act, double reward, PickSignal signal) {
        if (firstPickRight == null && (signal == PickSignal.ACCEPTED || signal == PickSignal.REJECTED)) {
            firstPickRight = signal == PickSignal.ACCEPTED;
        }
        seconds += domain.seconds(typeOf(act));
        discountedReturn += discount * reward;
        discount *= domain.discount();
        steps++;
        questions += act.verb().equals(AskType.VERB) ? 1 : 0;
    }

    private ActType typeOf(Act act) {
        return domain.types().stream().filter(t -> t.verb().equals(act.verb())).findFirst().orElseThrow();
    }

    /** The measures of an episode in which nobody had to wait between the acts. */
    Measures measures(HandoverBelief end) {
        return measures(end, seconds);
    }

    /** The measures of an episode that took so many seconds. */
    Measures measures(HandoverBelief end, double took) {
        int n = Math.max(1, steps);
        return new Measures(Boolean.TRUE.equals(firstPickRight), end.task().handovers() >= domain.spec().handovers(),
                took, steps, discountedReturn, questions, logScore / n, brierScore / n, distance / n);
    }
}
