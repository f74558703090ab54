package handover.contract;

import java.util.List;

/** The rules of the domain contract, by number. */
public final class Rules {
    private Rules() {}

    public static final List<Rule> ALL = List.of(
            new Rule(1, "acts depend on what is known only, are never repeated, and there is always one", ActRules::legal),
            new Rule(2, "acts are values: equal by verb and objects, found again by name", ActRules::values),
            new Rule(3, "what an act tells the human is a distribution over the acts of its type", ActRules::lambda),
            new Rule(4, "the human's belief stays a distribution after any act", ActRules::understanding),
            new Rule(5, "rates and answers are probabilities", ActRules::replies),
            new Rule(6, "transitions sum to one", ModelRules::sums),
            new Rule(7, "the transition sampler agrees with the transitions", ModelRules::sampler),
            new Rule(8, "rewards are finite, and the match reward is within its bound", ModelRules::rewards),
            new Rule(9, "what is known next depends on acts and on what is observed, not on what is hidden", ModelRules::known),
            new Rule(10, "terminal states absorb without reward", ModelRules::terminal),
            new Rule(11, "the observation sampler agrees with the likelihood", ObservationRules::sampler),
            new Rule(12, "every observation that is drawn is possible", ObservationRules::possible),
            new Rule(13, "states are values: equal, hashed and copied as such, with every variable readable", StateRules::values),
            new Rule(14, "a domain survives being written to a file", StateRules::serialisation),
            new Rule(15, "the filter agrees with Bayes' rule by enumeration of states", BeliefRules::filter),
            new Rule(16, "the search's reward is the expected reward of the states", BeliefRules::rewards),
            new Rule(17, "BURLAP's agent plays it in BURLAP's environment", BeliefRules::burlap),
            new Rule(18, "what the search leaves out by its bounds changes no value", BeliefRules::pruning));
}
