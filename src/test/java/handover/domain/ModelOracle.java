package handover.domain;

import handover.math.Vector3;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeSet;

/**
 * MODEL sections 3 and 4 a second time: read from the text, in the most naive way, slow on purpose. Shares nothing with
 * the code under test but plain data ({@link DomainSpec}, {@link Act}). Objects are numbered as in {@code present}.
 */
public final class ModelOracle {
    final DomainSpec spec;
    final List<TableObject> present;
    private final TreeSet<String> vocabulary = new TreeSet<>();

    /** @param present the objects that are on the table now */
    public ModelOracle(DomainSpec spec, List<TableObject> present) {
        this.spec = spec;
        this.present = present;
        spec.objects().forEach(o -> vocabulary.addAll(o.words().keySet()));
    }

    public int n() {
        return present.size();
    }

    /** T_tau(i given j). */
    public double transition(double tau, int i, int j) {
        return n() == 1 ? 1 : i == j ? tau : (1 - tau) / (n() - 1);
    }

    // ---- 3: what the robot may ask, with the words it says ---------------------------------------------------------

    /** Each set that may be asked about, with the words said. */
    public Map<List<String>, List<String>> questions() {
        Map<List<String>, List<String>> said = new LinkedHashMap<>();
        for (TableObject o : present) {
            said.put(List.of(o.name()), List.of(o.label().toLowerCase(Locale.ROOT).split("[^a-z0-9]+")));
        }
        if (spec.ask().sets() == AskSets.ATTRIBUTES) {
            for (String w : vocabulary) {
                List<String> set = having(w);
                boolean offered = set.size() > 1 && set.size() < n();
                // The words come in alphabetical order, so an equal total later in the alphabet loses.
                if (offered && (!said.containsKey(set) || total(w) > total(said.get(set).get(0)))) {
                    said.put(set, List.of(w));
                }
            }
        }
        return said;
    }

    private List<String> having(String word) {
        List<String> names = new ArrayList<>();
        for (TableObject o : present) {
            if (o.count(word) > 0) {
                names.add(o.name());
            }
        }
        return names;
    }

    private double total(String word) {
        double sum = 0;
        for (TableObject o : present) {
            sum += o.count(word);
        }
        return sum;
    }

    // ---- 3.1 to 3.3: what an act tells, and what it refers to --------------------------------------------------------

    /** lambda(act given i). */
    public double lambda(Act act, int i) {
        switch (act.verb()) {
            case "WAIT":
                return 1;
            case "PICK":
                double eps = spec.understanding().pickError();
                return n() == 1 ? 1 : is(act, i) ? 1 - eps : eps / (n() - 1);
            case "ASK":
                double all = 0;
                for (List<String> words : questions().values()) {
                    all += saying(words, i);
                }
                return saying(questions().get(act.objects()), i) / all;
            default:
                double sum = 0;
                for (int y = 0; y < n(); y++) {
                    sum += closeness(act.verb(), y, i);
                }
                return closeness(act.verb(), index(act.objects().get(0)), i) / sum;
        }
    }

    private double saying(List<String> words, int i) {
        double p = 1;
        for (String w : words) {
            p *= vocabulary.contains(w) ? word(w, i, null) : 1;
        }
        return p;
    }

    /** G_sigma(x, i). */
    private double closeness(String verb, int x, int i) {
        double sigma = verb.equals("POINT") ? spec.understanding().sigmaPoint() : spec.understanding().sigmaLook();
        double theta = PointingOracle.angle(spec.pointingOrigin(), present.get(x).position(), present.get(i).position());
        return Math.exp(-theta * theta / (2 * sigma * sigma));
    }

    /** M_act(i); NaN for a WAIT, which refers to what was open before it. */
    public double match(Act act, int i) {
        if (act.verb().equals("POINT") || act.verb().equals("LOOK")) {
            double sum = 0;
            for (int k = 0; k < n(); k++) {
                sum += closeness(act.verb(), index(act.objects().get(0)), k);
            }
            return closeness(act.verb(), index(act.objects().get(0)), i) / sum;
        }
        return act.verb().equals("WAIT") ? Double.NaN : is(act, i) ? 1 : 0;
    }

    /** U(h, act). */
    public double[] understood(double[] h, Act act) {
        double[] moved = new double[n()];
        double[] next = new double[n()];
        double z = 0;
        for (int i = 0; i < n(); i++) {
            for (int j = 0; j < n(); j++) {
                moved[i] += transition(spec.tauHuman(), i, j) * h[j];
            }
            next[i] = lambda(act, i) * moved[i];
            z += next[i];
        }
        for (int i = 0; i < n(); i++) {
            next[i] /= z;
        }
        // An act that nobody expected of any object divides 0 by 0 in the text: it is taken to tell nothing, as in 4.3.
        return z > 0 ? next : moved;
    }

    // ---- 4: what people say and show ---------------------------------------------------------------------------------

    /** p(word given i), in contrast to {@code open} if that is not null. */
    public double word(String w, int i, Act open) {
        double eta = spec.speech().contrast();
        if (open == null || is(open, i)) {
            return plainWord(w, i);
        }
        double all = 0;
        for (String each : vocabulary) {
            all += plainWord(each, i) * (1 - eta * (sharedWith(open, each) ? 1 : 0));
        }
        // If every word of i is shared and eta = 1, the text divides 0 by 0: then nothing else is left to say.
        return all > 0 ? plainWord(w, i) * (1 - eta * (sharedWith(open, w) ? 1 : 0)) / all : plainWord(w, i);
    }

    private double plainWord(String w, int i) {
        double sum = 0;
        for (double c : present.get(i).words().values()) {
            sum += c;
        }
        double alpha = spec.speech().alpha();
        return (present.get(i).count(w) + alpha) / (sum + alpha * vocabulary.size());
    }

    private boolean sharedWith(Act open, String word) {
        for (TableObject o : present) {
            if (open.objects().contains(o.name()) && o.count(word) > 0) {
                return true;
            }
        }
        return false;
    }

    /** The factor of a negated word. */
    public double negated(String w, int i) {
        return present.get(i).count(w) > 0 ? spec.speech().negationFactor() : 1;
    }

    /** P(the human says content words). */
    public double contentRate(Act act, double hWanted) {
        double rate = parameters(act).speechRate() + spec.speech().surprise() * (1 - hWanted);
        return rate < 0 ? 0 : rate > 0.99 ? 0.99 : rate;
    }

    /** P(answer given i) to an act while {@code open} is the open reference (the act itself where it is communicative). */
    public double answer(Answer answer, Act act, Act open, int i) {
        Act about = act.verb().equals("WAIT") ? open : act;
        if (about == null) {
            return answer == Answer.NONE ? 1 : 0;
        }
        double m = match(about, i);
        double e = spec.speech().answerError();
        double hit = parameters(act).answerIfMatch();
        double miss = parameters(act).answerIfMiss();
        double yes = m * hit * (1 - e) + (1 - m) * miss * e;
        double no = m * hit * e + (1 - m) * miss * (1 - e);
        return answer == Answer.YES ? yes : answer == Answer.NO ? no : m * (1 - hit) + (1 - m) * (1 - miss);
    }

    /** f(direction given i). */
    public double gesture(Gesture g, int i) {
        Vector3 s = g.shoulder();
        Vector3 hand = new Vector3(s.x() + g.direction().x(), s.y() + g.direction().y(), s.z() + g.direction().z());
        double theta = PointingOracle.angle(s, hand, present.get(i).position());
        double v = spec.gesture().variance();
        double eps = spec.gesture().outliers();
        return (1 - eps) * Math.exp(-theta * theta / (2 * v)) / PointingOracle.normaliser(v) + eps / (4 * Math.PI);
    }

    ActParameters parameters(Act act) {
        return spec.acts().get(act.verb().toLowerCase(Locale.ROOT));
    }

    private boolean is(Act act, int i) {
        return act.objects().contains(present.get(i).name());
    }

    int index(String name) {
        for (int i = 0; i < n(); i++) {
            if (present.get(i).name().equals(name)) {
                return i;
            }
        }
        throw new AssertionError(name + " is not on the table");
    }
}
