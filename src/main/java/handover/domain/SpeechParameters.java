package handover.domain;

import java.util.List;

/**
 * How people speak (MODEL 4.1). Immutable.
 *
 * @param alpha pseudo-count that smooths p(word | object); 0 is the report's formula
 * @param negationFactor factor on p(words | i) for each negated word that object i has
 * @param contrast eta, how much less likely a word is that an object just asked about also has
 * @param surprise kappa_s, how much more people speak when the robot seems about to do something else
 * @param answerError e, the probability that an answer is the wrong one
 * @param wordCounts P(1, 2, ... content words), sums to 1
 */
public record SpeechParameters(double alpha, double negationFactor, double contrast, double surprise,
        double answerError, List<Double> wordCounts) {
    private static final double ROUNDING = 1e-9;

    /** Checks every field; throws {@link InvalidParameterException}. */
    public SpeechParameters {
        Check.within("alpha", alpha, 0, 1e6, "a pseudo-count");
        Check.probability("negation_factor", negationFactor);
        Check.probability("contrast", contrast);
        Check.probability("surprise", surprise);
        Check.probability("answer_error", answerError);
        Check.present("word_counts", wordCounts, "the probabilities of 1, 2, ... words");
        double sum = 0;
        for (int k = 0; k < wordCounts.size(); k++) {
            String field = "word_counts[" + k + "]";
            sum += Check.probability(field, Check.present(field, wordCounts.get(k), "a probability"));
        }
        if (Math.abs(sum - 1) > ROUNDING) {
            throw new InvalidParameterException("word_counts", wordCounts, "probabilities of 1, 2, ... words that sum to 1");
        }
        wordCounts = List.copyOf(wordCounts);
    }

    /** The same people with another surprise. */
    public SpeechParameters withSurprise(double other) {
        return new SpeechParameters(alpha, negationFactor, contrast, other, answerError, wordCounts);
    }
}
