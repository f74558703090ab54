package handover.domain;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** MODEL sections 5 and 6 a second time: where an act of the base domain leads from a state, and what it pays. */
final class TransitionOracle {
    private static final double ROUND = 1e9;

    /** A next state by names; h rounded to 1e-9; {@code open} is the reference that is still open. */
    record Outcome(String wanted, List<String> onTable, Act open, Answer answer, PickSignal signal, int handovers,
            boolean done, List<Long> h) {}

    /** Probability of an outcome, and its expected reward times that probability. */
    record Weight(double probability, double reward) {}

    private final DomainSpec spec;
    private final ModelOracle now;
    private final Map<Outcome, Weight> outcomes = new HashMap<>();

    private TransitionOracle(DomainSpec spec, List<TableObject> present) {
        this.spec = spec;
        this.now = new ModelOracle(spec, present);
    }

    static Map<Outcome, Weight> outcomes(DomainSpec spec, HandoverState s, Act act) {
        TransitionOracle o = new TransitionOracle(spec, s.task().scene().objects());
        for (int i = 0; i < o.now.n(); i++) {
            o.follow(s, act, i, o.now.transition(spec.tau(), i, s.wanted()));
        }
        return o.outcomes;
    }

    /** All that may happen if the human wants {@code i} when the act has started. */
    private void follow(HandoverState s, Act act, int i, double p) {
        boolean picks = act.verb().equals("PICK");
        Act before = s.task().openReference();
        Act open = picks ? null : act.equals(Act.WAIT) ? before : act;
        double[] h = now.understood(s.human(), act);
        double reward = now.parameters(act).reward() + match(i, h);
        if (!picks && !act.equals(Act.WAIT) && act.equals(before)) {
            reward += spec.rewards().annoyance();
        }
        int handovers = s.task().handovers();
        String wanted = now.present.get(i).name();
        if (!picks) {
            for (Answer answer : Answer.values()) {
                Act left = answer == Answer.NONE ? open : null;
                add(new Outcome(wanted, names(now.present), left, answer, PickSignal.NONE, handovers, false, round(h)),
                        p * now.answer(answer, act, open, i), reward);
            }
            return;
        }
        boolean right = act.objects().get(0).equals(wanted);
        reward += right ? spec.rewards().right() : spec.rewards().wrong();
        List<TableObject> left = new ArrayList<>(now.present);
        if (right || spec.wrongPick() == WrongPick.REMOVED) {
            left.remove(now.index(act.objects().get(0)));
        }
        int n = left.size();
        int after = handovers + (right ? 1 : 0);
        boolean done = after >= spec.handovers() || n == 0 || !right && spec.wrongPick() == WrongPick.TERMINAL;
        List<Long> uniform = round(new double[n], 1.0 / n);
        PickSignal signal = right ? PickSignal.ACCEPTED : PickSignal.REJECTED;
        List<String> wishes = !right ? List.of(wanted) : n == 0 ? List.of("") : names(left);
        for (String wish : wishes) {
            add(new Outcome(wish, names(left), null, Answer.NONE, signal, after, done, uniform), p / wishes.size(), reward);
        }
    }

    private void add(Outcome outcome, double p, double reward) {
        if (p > 0) {
            outcomes.merge(outcome, new Weight(p, p * reward),
                    (a, b) -> new Weight(a.probability + b.probability, a.reward + b.reward));
        }
    }

    /** kappa S(e_i, h) for the scores that are the expectation of a reward of states, else 0. */
    private double match(int i, double[] h) {
        double[] e = new double[h.length];
        e[i] = 1;
        double kappa = spec.rewards().matchWeight();
        switch (spec.rewards().matchScore()) {
            case BRIER:
                double squares = 0;
                for (int k = 0; k < h.length; k++) {
                    squares += (e[k] - h[k]) * (e[k] - h[k]);
                }
                return -kappa * squares;
            case LOG:
                return kappa * Math.log(0.999 * h[i] + 0.001 / h.length);
            case LINEAR:
                return kappa * h[i];
            default:
                return 0;
        }
    }

    static Outcome of(HandoverState s) {
        Task task = s.task();
        List<TableObject> objects = task.scene().objects();
        return new Outcome(s.wanted() < 0 ? "" : objects.get(s.wanted()).name(), names(objects), task.openReference(),
                task.answer(), task.signal(), task.handovers(), task.done(), round(s.human()));
    }

    private static List<String> names(List<TableObject> objects) {
        return objects.stream().map(TableObject::name).toList();
    }

    private static List<Long> round(double[] h) {
        List<Long> rounded = new ArrayList<>();
        for (double x : h) {
            rounded.add(Math.round(x * ROUND));
        }
        return rounded;
    }

    private static List<Long> round(double[] h, double value) {
        java.util.Arrays.fill(h, value);
        return round(h);
    }
}
