package handover.domain;

import handover.math.Vector3;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.random.RandomGenerator;

/**
 * What people say and show, given what they want: likelihoods and the matching samplers (MODEL section 4). The only place
 * for these numbers; stateless, thread safe.
 */
public final class HumanModel {
    private HumanModel() {}

    /**
     * Adds log p(words | i), and the factor of negated words, to {@code out} (modified) for each object.
     *
     * @param reference what the words are said in contrast to, null if nothing is open
     * @return whether any object can have been meant
     */
    public static boolean addLogWords(Scene scene, ActModel reference, Utterance said, double[] out) {
        HandoverDomain domain = scene.domain();
        Words table = scene.words(reference);
        boolean possible = false;
        for (int i = 0; i < out.length; i++) {
            double log = 0;
            for (String word : said.content()) {
                int w = domain.vocabulary().indexOf(word);
                log += w < 0 ? 0 : Math.log(table.probabilities(w)[i]);
            }
            for (String word : said.negated()) {
                boolean has = scene.objects().get(i).count(word) > 0;
                log += has ? Math.log(domain.spec().speech().negationFactor()) : 0;
            }
            possible |= log > Double.NEGATIVE_INFINITY;
            out[i] += log;
        }
        return possible;
    }

    /**
     * log P(number of content words) of each reading of an utterance: what makes readings of different length comparable.
     * Longer readings than people are modelled to say count as the longest; 0 for all if none of them is possible.
     */
    public static double[] logWordCounts(HandoverDomain domain, List<Speech.Alternative> alternatives) {
        List<Double> p = domain.spec().speech().wordCounts();
        double[] log = alternatives.stream().mapToInt(a -> a.utterance().content().size())
                .mapToDouble(k -> k == 0 ? 0 : Math.log(p.get(Math.min(k, p.size()) - 1))).toArray();
        return Arrays.stream(log).allMatch(x -> x == Double.NEGATIVE_INFINITY) ? new double[log.length] : log;
    }

    /** f(direction | i) per steradian for each object, as a new array. Throws if the shoulder is at an object. */
    public static double[] gestureDensities(Scene scene, Gesture gesture) {
        return Arrays.stream(logGestureDensities(scene, gesture)).map(Math::exp).toArray();
    }

    /** log f(direction | i), which does not underflow, as a new array. Throws if the shoulder is at an object. */
    public static double[] logGestureDensities(Scene scene, Gesture gesture) {
        double[] log = new double[scene.size()];
        for (int i = 0; i < log.length; i++) {
            Vector3 arm = scene.objects().get(i).position().minus(gesture.shoulder());
            if (arm.norm() < Check.TOO_CLOSE) {
                throw new InvalidParameterException("shoulder", gesture.shoulder(), "a shoulder at least "
                        + Check.TOO_CLOSE + " m from " + scene.objects().get(i).name());
            }
            log[i] = scene.domain().pointing().logDensity(gesture.direction().angleTo(arm));
        }
        return log;
    }

    /** A gesture of somebody who means object {@code i}, from the shoulder of the domain file. */
    public static Gesture sampleGesture(Scene scene, int i, RandomGenerator random) {
        Vector3 shoulder = scene.domain().spec().shoulder();
        Vector3 arm = scene.objects().get(i).position().minus(shoulder);
        return new Gesture(shoulder, scene.domain().pointing().sample(arm, random));
    }

    /** Words of somebody who means object {@code i}: how many by P(1, 2, ...), each by p(w | i). */
    public static List<String> sampleWords(Scene scene, ActModel reference, int i, RandomGenerator random) {
        List<String> words = new ArrayList<>();
        for (int k = sampleWordCount(scene.domain(), random); k > 0; k--) {
            words.add(scene.domain().vocabulary().words().get(scene.words(reference).sample(i, random)));
        }
        return words;
    }

    /** A number of content words, at least 1. */
    public static int sampleWordCount(HandoverDomain domain, RandomGenerator random) {
        List<Double> p = domain.spec().speech().wordCounts();
        double u = random.nextDouble();
        int k = 0;
        while (k < p.size() - 1 && (u -= p.get(k)) >= 0) {
            k++;
        }
        return k + 1;
    }

    /** The answer at level {@code u} in [0, 1) of P(answer | i), in the order yes, no, none. */
    public static Answer answer(ActEffect effect, int i, double u) {
        double afterYes = u - effect.answers().yes()[i];
        return afterYes < 0 ? Answer.YES : afterYes < effect.answers().no()[i] ? Answer.NO : Answer.NONE;
    }
}
