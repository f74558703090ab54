package handover.domain;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** ASK(X): "the red ball?" for one object, "something red?" for all that share a word (MODEL 3). */
public final class AskType extends ActType {
    public static final String VERB = "ASK";

    private final AskSets sets;
    private final Vocabulary vocabulary;

    public AskType(ActParameters parameters, AskSets sets, Vocabulary vocabulary) {
        super(VERB, parameters);
        this.sets = sets;
        this.vocabulary = vocabulary;
    }

    @Override
    public List<Act> acts(List<TableObject> present) {
        List<Act> acts = new ArrayList<>();
        present.forEach(o -> acts.add(Act.of(VERB, o.name())));
        if (sets == AskSets.ATTRIBUTES) {
            acts.addAll(attributeWords(present).keySet().stream().map(set -> new Act(VERB, set))
                    .sorted(Comparator.comparing(Act::toString)).toList());
        }
        return acts;
    }

    /** p(words said | i), without the words that nobody uses for anything. */
    @Override
    public double[] weights(Act act, List<TableObject> present) {
        double[] w = super.weights(act, present);
        for (String word : Utterance.tokens(say(act, present))) {
            int k = vocabulary.indexOf(word);
            for (int i = 0; k >= 0 && i < w.length; i++) {
                w[i] *= vocabulary.probability(k, present.get(i));
            }
        }
        return w;
    }

    @Override
    public double[] match(Act act, List<TableObject> present) {
        double[] m = new double[present.size()];
        for (String name : act.objects()) {
            m[indexOf(name, present)] = 1;
        }
        return m;
    }

    @Override
    public String say(Act act, List<TableObject> present) {
        if (act.objects().size() == 1) {
            return present.get(indexOf(act.objects().get(0), present)).label();
        }
        return attributeWords(present).get(act.objects());
    }

    /** Each set of 2 to N-1 objects that share a word, with the word of largest total count (ties: alphabetical). */
    private Map<List<String>, String> attributeWords(List<TableObject> present) {
        Map<List<String>, String> word = new HashMap<>();
        Map<List<String>, Double> most = new HashMap<>();
        for (String w : vocabulary.words()) {
            List<String> set = present.stream().filter(o -> o.count(w) > 0).map(TableObject::name).toList();
            double total = present.stream().mapToDouble(o -> o.count(w)).sum();
            if (set.size() > 1 && set.size() < present.size() && total > most.getOrDefault(set, 0.0)) {
                most.put(set, total);
                word.put(set, w);
            }
        }
        return word;
    }
}
