package handover.theory;

import handover.math.Simplex;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * What the other may have perceived of one act of {@code S}: the acts a~ with their probabilities P(a~ | a). A missed act
 * is {@link Message#nothing}. Immutable, thread safe.
 *
 * @param probabilities P(a~ | a), one per message, summing to one; copied
 * @param messages what each a~ says; equally many
 * @param <S> who acted
 */
public record Perception<S extends Agent<?, ?>>(double[] probabilities, List<Message<S>> messages) {
    /** Throws {@link IllegalArgumentException} if it is no distribution, or sizes differ. */
    public Perception {
        probabilities = Weights.distribution("perception", probabilities);
        messages = List.copyOf(messages);
        Weights.sameSize("perceived messages", probabilities.length, messages.size());
        for (Message<S> m : messages) {
            Weights.sameSize("perceived message", messages.get(0).size(), m.size());
        }
    }

    /** Perceived as it was meant. */
    public static <S extends Agent<?, ?>> Perception<S> exact(Message<S> message) {
        return new Perception<>(new double[] {1}, List.of(message));
    }

    /**
     * Noticed with probability {@code attention}; if noticed, taken for another of the acts with probability
     * {@code confusion}, each equally likely; else missed.
     *
     * @param acts what each act that there is says
     * @param done index of the act that was done
     * @param attention q in [0, 1]
     * @param confusion in [0, 1]; without effect if there is only one act
     */
    public static <S extends Agent<?, ?>> Perception<S> confused(List<Message<S>> acts, int done, double attention,
            double confusion) {
        Weights.probability("attention", attention);
        Weights.probability("confusion", acts.size() == 1 ? 0 : confusion);
        double[] p = new double[acts.size() + 1];
        for (int a = 0; a < acts.size(); a++) {
            p[a] = attention * (acts.size() == 1 ? 1 : a == done ? 1 - confusion : confusion / (acts.size() - 1));
        }
        p[acts.size()] = 1 - attention;
        List<Message<S>> messages = new ArrayList<>(acts);
        messages.add(Message.nothing(acts.get(0).size()));
        return new Perception<>(p, messages).possible();
    }

    /**
     * P(a~ | a, e): what may have been perceived, after something that depends on it, such as an answer. To let the nested
     * belief have the benefit, update it again from where it was before the act.
     *
     * @param likelihoods p(e | a~), one per message, not negative; all zero counts as no evidence
     */
    public Perception<S> given(double[] likelihoods) {
        Weights.sameSize("likelihoods of perceived acts", size(), likelihoods.length);
        return new Perception<>(Categorical.corrected(probabilities, Weights.checked("likelihoods", likelihoods)), messages);
    }

    /** p(e) = sum_a~ P(a~ | a) p(e | a~); {@code likelihoods} is not modified. */
    public double probability(double[] likelihoods) {
        double s = 0;
        for (int a = 0; a < probabilities.length; a++) {
            s += probabilities[a] * likelihoods[a];
        }
        return s;
    }

    /** How many acts may have been perceived. */
    public int size() {
        return probabilities.length;
    }

    /** How many objects the acts are about. */
    public int objects() {
        return messages.get(0).size();
    }

    private Perception<S> possible() {
        List<Message<S>> kept = new ArrayList<>();
        double[] p = new double[size()];
        for (int a = 0; a < size(); a++) {
            if (probabilities[a] > 0) {
                p[kept.size()] = probabilities[a];
                kept.add(messages.get(a));
            }
        }
        p = Arrays.copyOf(p, kept.size());
        Simplex.normalise(p, p.length);
        return new Perception<>(p, kept);
    }

    @Override
    public boolean equals(Object o) {
        return o instanceof Perception<?> p && Arrays.equals(probabilities, p.probabilities) && messages.equals(p.messages);
    }

    @Override
    public int hashCode() {
        return 31 * Arrays.hashCode(probabilities) + messages.hashCode();
    }
}
