package handover.tabular;

/**
 * What is believed about the state, and how often something was observed that the model says cannot be: such an observation
 * tells nothing, so that the belief is only propagated. Immutable, thread safe; the array must not be modified.
 *
 * @param probabilities of the states
 * @param unforeseen observations of probability 0 so far
 */
public record TabularBelief(double[] probabilities, int unforeseen) {

    /** The belief at the start. */
    public static TabularBelief start(TabularPomdp pomdp) {
        return new TabularBelief(pomdp.start(), 0);
    }

    /** After an act and what was observed then. */
    public TabularBelief after(TabularPomdp pomdp, int act, int observation) {
        double[] b = new double[probabilities.length];
        pomdp.predict(probabilities, act, b);
        boolean foreseen = pomdp.correct(b, act, observation) > 0;
        return new TabularBelief(b, foreseen ? unforeseen : unforeseen + 1);
    }
}
