package handover.tabular;

/**
 * What is believed about the state, and how often something was observed that the model says cannot be: such an observation
 * tells nothing, so that the belief is only propagated. Immutable, thread safe; the array must not be modified.
 *
 * @param probabilities of the states
 * @param unforeseen observations of probability 0 so far
 */
record TabularBelief(double[] probabilities, int unforeseen) {

    /** The belief at the start. */
    static TabularBelief start(TabularPomdp pomdp) {
        return new TabularBelief(pomdp.start(), 0);
    }

    /** After an act and what was observed then. */
    TabularBelief after(TabularPomdp pomdp, int act, int observation) {
        double[] predicted = new double[probabilities.length];
        double[] corrected = new double[probabilities.length];
        pomdp.predict(probabilities, act, predicted);
        boolean foreseen = pomdp.correct(predicted, act, observation, corrected) > 0;
        return foreseen ? new TabularBelief(corrected, unforeseen) : new TabularBelief(predicted, unforeseen + 1);
    }
}
