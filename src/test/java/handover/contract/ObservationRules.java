package handover.contract;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import burlap.mdp.core.state.State;
import handover.domain.Answer;
import handover.domain.Observation;
import handover.domain.Speech;
import handover.domain.Task;
import handover.domain.Utterance;
import java.util.ArrayList;
import java.util.List;

/** Rules about what is sensed. */
final class ObservationRules {
    private static final int SAMPLES = 3000;
    /** Standard deviations; a sound domain exceeds them once in 10^8 comparisons, of which a walk makes some 200. */
    private static final double FAR = 5.7;

    private ObservationRules() {}

    /** The share of draws that are exactly "nothing but the answer" or "one word and no gesture" against its probability. */
    static void sampler(Walk walk) {
        List<Walk.Visit> visits = walk.visits();
        for (int k = 0; k < visits.size(); k += 1 + visits.size() / 20) {
            Walk.Visit v = visits.get(k);
            List<State> drawn = new ArrayList<>();
            for (int n = 0; n < SAMPLES; n++) {
                drawn.add(walk.senses.sample(v.next(), v.act()));
            }
            for (Observation o : without(v, walk)) {
                double p = walk.senses.probability(o, v.next(), v.act());
                assertTrue(p >= 0 && p <= 1, "probability " + p + " of " + o + " " + v);
                double count = drawn.stream().filter(o::equals).count();
                double sd = Math.sqrt(SAMPLES * p * (1 - p));
                assertEquals(SAMPLES * p, count, FAR * sd + 3, "draws of " + o + " " + v);
            }
        }
    }

    private static List<Observation> without(Walk.Visit v, Walk walk) {
        Task task = Walk.base(v.next()).task();
        List<Observation> all = new ArrayList<>();
        all.add(observation(task, List.of()));
        walk.domain.vocabulary().words().forEach(w -> all.add(observation(task, List.of(w))));
        return all;
    }

    private static Observation observation(Task task, List<String> words) {
        boolean silent = task.answer() == Answer.NONE && words.isEmpty();
        Speech speech = silent ? null : Speech.of(new Utterance(task.answer(), words, List.of(), List.of()));
        return new Observation(speech, null, task.signal());
    }

    static void possible(Walk walk) {
        for (Walk.Visit v : walk.visits()) {
            for (int n = 0; n < 20; n++) {
                State o = walk.senses.sample(v.next(), v.act());
                double p = walk.senses.probability(o, v.next(), v.act());
                assertTrue(p > 0 && p < Double.POSITIVE_INFINITY, "drew " + o + " of density " + p + " " + v);
            }
        }
    }
}
