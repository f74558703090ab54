package handover.theory;

/**
 * One of the two agents at its own time: the robot &lt;i, b, B&gt; at t, the human &lt;iota, beta, B&gt; at tau = t +
 * 1/2. The report writes the robot's; the human's is the same with the roles exchanged. Immutable; thread safe if {@code
 * nested} is.
 *
 * @param now when it acts next
 * @param own item level: its own choice, given what the other did
 * @param belief categorical level: what it believes about the other's choice
 * @param nested Dirichlet level: what it believes about the other's belief about its own choice
 */
public record Mind<Self extends Agent<Self, Other>, Other extends Agent<Other, Self>>(Moment<Self, Other> now,
        Choice<Self> own, Categorical<Other> belief, Nested<Self> nested) {
    /** Throws {@link IllegalArgumentException} if the three levels are about different numbers of objects. */
    public Mind {
        Weights.sameSize("belief", own.probabilities().length, belief.size());
        Weights.sameSize("nested belief", own.probabilities().length, nested.size());
    }

    /**
     * It acts: only B moves, because the other will have perceived the act, or something like it, half a step later.
     *
     * @param t how the other thinks that the own choice has moved since the last act (MODEL 3.2: T_tau_H, or the
     *     compliance that the other expects)
     * @param act what the other may perceive
     */
    public Mind<Self, Other> acts(Transition<Self> t, Perception<Self> act) {
        return new Mind<>(now, own, belief, nested.updated(t, act));
    }

    /**
     * The other acts, half a step after this one: the own choice may comply, b is updated, and B is corrected by what the
     * act says about the other's belief. A whole step of the own clock passes.
     *
     * @param when the other acted; must be half a step after this agent's moment
     * @param t how the other's choice moves
     * @param act what the other's act says about its choice
     * @param evidence what the other's act says about its belief; {@code null} if nothing
     * @param compliance c of the item level, in [0, 1]
     * @throws IllegalArgumentException if it was not the other's turn
     */
    public Mind<Self, Other> hears(Moment<Other, Self> when, Transition<Other> t, Message<Other> act,
            Evidence<Self> evidence, double compliance) {
        if (!when.equals(now.next())) {
            throw new IllegalArgumentException("when: expected the other to act at " + now.next() + ", got " + when);
        }
        Choice<Self> complied = own.moved(Transition.compliance(compliance, act));
        return new Mind<>(when.next(), complied, belief.updated(t, act), evidence == null ? nested : nested.given(evidence));
    }
}
