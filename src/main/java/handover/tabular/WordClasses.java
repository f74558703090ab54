package handover.tabular;

import handover.domain.ActModel;
import handover.domain.HandoverDomain;
import handover.domain.Scene;
import handover.domain.Words;
import java.util.ArrayList;
import java.util.List;

/**
 * The vocabulary with words put together that no object tells apart: where p(w | i) of one is a multiple of that of the other,
 * whatever reference is open, so that hearing one is the same evidence as hearing the other. Immutable, thread safe.
 */
final class WordClasses {
    private static final double SAME = 1e-12;

    private final HandoverDomain domain;
    /** The words of each class, by number. */
    private final List<List<Integer>> classes = new ArrayList<>();

    WordClasses(HandoverDomain domain) {
        this.domain = domain;
        List<Words> tables = tables(domain.start());
        for (int w = 0; w < domain.vocabulary().size(); w++) {
            int word = w;
            List<Integer> home = classes.stream().filter(c -> tables.stream().allMatch(t -> proportional(
                    t.probabilities(c.get(0)), t.probabilities(word)))).findFirst().orElse(null);
            if (home == null) {
                home = new ArrayList<>();
                classes.add(home);
            }
            home.add(w);
        }
    }

    private static List<Words> tables(Scene scene) {
        List<Words> all = new ArrayList<>(List.of(scene.words(null)));
        if (scene.domain().spec().speech().contrast() > 0) {
            scene.acts().stream().filter(ActModel::isCommunicative).forEach(m -> all.add(scene.words(m)));
        }
        return all;
    }

    private static boolean proportional(double[] p, double[] q) {
        double sumP = 0;
        double sumQ = 0;
        for (int i = 0; i < p.length; i++) {
            sumP += p[i];
            sumQ += q[i];
        }
        for (int i = 0; i < p.length; i++) {
            if (Math.abs(p[i] * sumQ - q[i] * sumP) > SAME * sumP * sumQ) {
                return false;
            }
        }
        return true;
    }

    /** The class of a word of the vocabulary, -1 for another one. */
    int of(String word) {
        int w = domain.vocabulary().indexOf(word);
        for (int c = 0; c < classes.size(); c++) {
            if (classes.get(c).contains(w)) {
                return c;
            }
        }
        return -1;
    }

    String name(int c) {
        return domain.vocabulary().words().get(classes.get(c).get(0));
    }

    /** {@code blue = turquoise}, for classes of more than one word. */
    List<String> merged() {
        return classes.stream().filter(c -> c.size() > 1).map(c -> String.join(" = ",
                c.stream().map(w -> domain.vocabulary().words().get(w)).toList())).toList();
    }

    /** P(class | object i), given that a word is said. */
    double[] probabilities(Words table, int i) {
        return classes.stream().mapToDouble(c -> c.stream().mapToDouble(w -> table.probabilities(w)[i]).sum()).toArray();
    }
}
