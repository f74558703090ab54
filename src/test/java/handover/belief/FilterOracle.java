package handover.belief;

import handover.domain.Act;
import handover.domain.Answer;
import handover.domain.DomainSpec;
import handover.domain.ModelOracle;
import handover.domain.Observation;
import handover.domain.PickSignal;
import handover.domain.Speech;
import handover.domain.TableObject;
import handover.domain.Utterance;
import handover.domain.WrongPick;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * MODEL 4.4 and 5 a second time: the robot's belief step by step in plain probabilities, for short utterances. Changes as it
 * goes. Base variant.
 */
final class FilterOracle {
    private final DomainSpec spec;
    private List<TableObject> present;
    double[] b;
    double[] h;
    /** The reference that is still open. */
    private Act open;

    /** @param b belief to start with, copied */
    FilterOracle(DomainSpec spec, double[] b) {
        this.spec = spec;
        this.present = spec.objects();
        this.b = b.clone();
        this.h = uniform(b.length);
    }

    /**
     * One step.
     *
     * @return false if the observation has likelihood 0 for every object, so that the belief was only propagated
     */
    boolean step(Act act, Observation o) {
        ModelOracle oracle = new ModelOracle(spec, present);
        double[] predicted = new double[present.size()];
        for (int i = 0; i < predicted.length; i++) {
            for (int j = 0; j < predicted.length; j++) {
                predicted[i] += oracle.transition(spec.tau(), i, j) * b[j];
            }
        }
        h = oracle.understood(h, act);
        b = predicted;
        boolean picks = act.verb().equals("PICK");
        open = picks ? null : act.equals(Act.WAIT) ? open : act;
        if (picks) {
            pick(act.objects().get(0), o.signal() == PickSignal.ACCEPTED);
            oracle = new ModelOracle(spec, present);
        }
        double[] posterior = new double[present.size()];
        for (int i = 0; i < posterior.length; i++) {
            posterior[i] = b[i] * speech(oracle, o.speech(), act, picks, i)
                    * (o.gesture() == null ? 1 : oracle.gesture(o.gesture(), i));
        }
        if (!picks && o.speech() != null && o.speech().answer() != Answer.NONE) {
            open = null;
        }
        double z = Arrays.stream(posterior).sum();
        if (z > 0) {
            b = Arrays.stream(posterior).map(p -> p / z).toArray();
        }
        return z > 0;
    }

    /** The likelihood of all that was said in the step, where the rate of gestures and the number of words cancel. */
    private double speech(ModelOracle oracle, Speech speech, Act act, boolean picked, int i) {
        List<Speech.Alternative> heard = speech == null ? List.of(new Speech.Alternative(Utterance.SILENCE, 1))
                : speech.alternatives();
        double sum = 0;
        for (Speech.Alternative a : heard) {
            Utterance said = a.utterance();
            double rate = oracle.contentRate(act, h[i]);
            double p = said.content().isEmpty() ? 1 - rate : rate * share(said.content().size());
            for (String w : said.content()) {
                p *= oracle.word(w, i, open);
            }
            for (String w : said.negated()) {
                p *= oracle.negated(w, i);
            }
            double answer = picked ? said.answer() == Answer.NONE ? 1 : 0 : oracle.answer(said.answer(), act, open, i);
            sum += a.confidence() * p * answer;
        }
        return sum;
    }

    /** P(so many words): matters only between the alternatives of an n-best list. */
    private double share(int words) {
        return spec.speech().wordCounts().get(words - 1);
    }

    private void pick(String target, boolean accepted) {
        List<TableObject> left = new ArrayList<>();
        List<Double> beliefs = new ArrayList<>();
        boolean leaves = accepted || spec.wrongPick() == WrongPick.REMOVED;
        for (int i = 0; i < present.size(); i++) {
            boolean it = present.get(i).name().equals(target);
            if (!it || !leaves) {
                left.add(present.get(i));
                beliefs.add(it ? 0 : b[i]);
            }
        }
        present = left;
        double sum = beliefs.stream().mapToDouble(p -> p).sum();
        b = accepted ? uniform(left.size()) : beliefs.stream().mapToDouble(p -> p / sum).toArray();
        h = uniform(left.size());
    }

    private static double[] uniform(int n) {
        double[] p = new double[n];
        Arrays.fill(p, 1.0 / n);
        return p;
    }
}
