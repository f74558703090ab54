package handover.domain;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/**
 * The objects on the table and everything that follows from them alone: the acts on offer with what they mean, and
 * p(word | object). Equal if the objects are. Immutable, thread safe; arrays must not be modified.
 */
public final class Scene {
    private final HandoverDomain domain;
    private final List<TableObject> objects;
    private final Map<String, Integer> indexOf = new LinkedHashMap<>();
    /** What follows from the objects; computed when it is first asked for, because many tables are never played on. */
    private volatile Tables tables;
    private final Map<Act, Words> contrasted = new ConcurrentHashMap<>();
    private final Map<Asked, Answers> answers = new ConcurrentHashMap<>();
    private final Answers silence;
    private final Scene[] without;
    private final Map<Task.Key, Task> tasks = new ConcurrentHashMap<>();
    private final int hash;

    Scene(HandoverDomain domain, List<TableObject> objects) {
        this.domain = domain;
        this.objects = List.copyOf(objects);
        for (TableObject o : objects) {
            indexOf.put(o.name(), indexOf.size());
        }
        this.silence = Answers.silence(objects.size());
        this.without = new Scene[objects.size()];
        this.hash = this.objects.hashCode();
    }

    private record Tables(List<ActModel> acts, Map<Act, ActModel> models, List<List<Percept>> percepts, boolean exact, Words words) {}

    private Tables tables() {
        Tables t = tables;
        if (t == null) {
            List<ActModel> acts = modelActs(domain.types(), objects);
            Map<Act, ActModel> models = new HashMap<>();
            acts.forEach(m -> models.put(m.act(), m));
            List<List<Percept>> percepts = acts.stream()
                    .map(m -> m.isCommunicative() ? domain.percepts(m, acts) : Percept.exact(m)).toList();
            boolean exact = acts.stream().allMatch(m -> percepts.get(m.index()).equals(Percept.exact(m)));
            t = new Tables(List.copyOf(acts), models, percepts, exact, Words.plain(domain.vocabulary(), objects));
            tables = t;
        }
        return t;
    }

    public HandoverDomain domain() {
        return domain;
    }

    public List<TableObject> objects() {
        return objects;
    }

    /** N, the number of objects. */
    public int size() {
        return objects.size();
    }

    /** The position of an object, -1 if it is not on the table. */
    public int indexOf(String name) {
        return indexOf.getOrDefault(name, -1);
    }

    /** All acts, type by type. */
    public List<ActModel> acts() {
        return tables().acts;
    }

    /** What the human may take an act for. */
    public List<Percept> percepts(ActModel act) {
        return tables().percepts.get(act.index());
    }

    /** Whether what the human perceives is known for every act, so that h is a function of the robot's own acts. */
    public boolean perceivedExactly() {
        return tables().exact;
    }

    /** The model of an act, null if the act is not on offer here. Its objects may be named in any order. */
    public ActModel model(Act act) {
        Map<Act, ActModel> models = tables().models;
        ActModel model = models.get(act);
        if (model == null && act.objects().size() > 1) {
            List<String> inTableOrder = act.objects().stream().sorted(Comparator.comparingInt(this::indexOf)).toList();
            model = models.get(new Act(act.verb(), inTableOrder));
        }
        return model;
    }

    /** p(word | i), in contrast to an open reference if it is not null (MODEL 4.1). */
    public Words words(ActModel reference) {
        double eta = domain.spec().speech().contrast();
        Words plain = tables().words;
        return eta == 0 || reference == null ? plain : contrasted.computeIfAbsent(reference.act(),
                act -> plain.contrast(domain.vocabulary(), objects, act, eta));
    }

    /** An act of a type, and the act whose reference it leaves open (often itself). */
    private record Asked(String verb, Act reference) {}

    /** Who answers what to an act; {@code reference} is what the human then takes to be asked about. */
    Answers answers(ActModel act, ActModel reference) {
        return answers.computeIfAbsent(new Asked(act.type().verb(), reference.act()),
                a -> Answers.to(domain, act.type(), reference.match()));
    }

    /** Nobody answers. */
    Answers silence() {
        return silence;
    }

    /** The same table without object {@code i}. */
    public Scene without(int i) {
        synchronized (without) {
            if (without[i] == null) {
                List<TableObject> rest = new ArrayList<>(objects);
                rest.remove(i);
                without[i] = new Scene(domain, rest);
            }
            return without[i];
        }
    }

    /** The one task with these values on this scene, so that what is cached with a task is found again. */
    Task task(Task.Key key) {
        return tasks.computeIfAbsent(key, k -> new Task(this, k));
    }

    private static List<ActModel> modelActs(List<ActType> types, List<TableObject> objects) {
        List<ActModel> models = new ArrayList<>();
        if (objects.isEmpty()) {
            return models;
        }
        for (ActType type : types) {
            List<Act> acts = type.acts(objects);
            double[][] lambda = normalise(acts.stream().map(a -> type.weights(a, objects)).toArray(double[][]::new),
                    objects.size());
            for (int k = 0; k < acts.size(); k++) {
                Act act = acts.get(k);
                models.add(new ActModel(models.size(), act, type, lambda[k], type.match(act, objects),
                        type.target(act, objects), type.say(act, objects)));
            }
        }
        return models;
    }

    /** Divides by the sum over the acts of the type, for each object; an object that no act fits is told nothing. */
    private static double[][] normalise(double[][] weights, int n) {
        for (int i = 0; i < n; i++) {
            double sum = 0;
            for (double[] w : weights) {
                sum += w[i];
            }
            for (double[] w : weights) {
                w[i] = sum > 0 ? w[i] / sum : 1.0 / weights.length;
            }
        }
        return weights;
    }

    @Override
    public boolean equals(Object o) {
        return this == o || o instanceof Scene s && hash == s.hash && objects.equals(s.objects);
    }

    @Override
    public int hashCode() {
        return hash;
    }

    @Override
    public String toString() {
        return indexOf.keySet().toString();
    }
}
