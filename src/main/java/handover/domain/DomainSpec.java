package handover.domain;

import handover.math.MatchScore;
import handover.math.Vector3;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Consumer;

/**
 * Everything that a domain file says, checked: the content of a handover problem as plain data. Immutable.
 *
 * @param name of the domain
 * @param description one line for people
 * @param variant name of a shipped variant, or of a class that extends {@link HandoverDomain}
 * @param objects on the table at the start, at least one
 * @param prior b_0, object name to probability, summing to 1; empty for uniform
 * @param pointingOrigin where the robot points and looks from, metres
 * @param shoulder where the human points from unless a gesture says otherwise, metres
 * @param tau probability that the human still wants the same object a step later
 * @param tauHuman tau_H, the same as the human thinks of the robot's choice
 * @param handovers how many objects are to be handed over
 * @param wrongPick what happens to an object that was not wanted
 * @param ask what may be asked about
 * @param understanding how people read the robot's acts
 * @param perception how often they miss or misread them
 * @param speech how people speak
 * @param gesture how people point
 * @param rewards what is paid
 * @param pick of the variants with incremental picks
 * @param communicated of the variants in which the human's expectation is a hidden object
 * @param acts verb in lower case to the parameters of that type of act
 * @param frames name to where that frame lies, for positions that sensors give in it
 * @param adapters topic to how that topic is read, for sensors that somebody else publishes
 */
public record DomainSpec(String name, String description, String variant, List<TableObject> objects, Map<String, Double> prior,
        Vector3 pointingOrigin, Vector3 shoulder, double tau, double tauHuman, int handovers, WrongPick wrongPick,
        AskParameters ask, Understanding understanding, PerceptionParameters perception, SpeechParameters speech, GestureParameters gesture,
        Rewards rewards, PickParameters pick, CommunicatedParameters communicated, Map<String, ActParameters> acts,
        Map<String, Frame> frames, Map<String, Adapter> adapters) {
    /** The variant of the base domain. */
    public static final String BASE = "base";

    private static final double ROUNDING = 1e-6;

    /** Checks every field and how they go together; throws {@link InvalidParameterException}. */
    public DomainSpec {
        if (name == null || name.isBlank()) {
            throw new InvalidParameterException("name", name, "the domain's name");
        }
        description = description == null ? "" : description;
        if (variant == null || variant.isBlank()) {
            throw new InvalidParameterException("variant", variant, "a variant of the domain");
        }
        Check.position("pointing_origin", pointingOrigin);
        Check.position("shoulder", shoulder);
        objects = List.copyOf(Check.present("objects", objects, "a list of objects"));
        if (objects.isEmpty()) {
            throw new InvalidParameterException("objects", "expected at least 1 object, got none");
        }
        checkObjects(objects, pointingOrigin, shoulder);
        prior = checkPrior(prior == null ? Map.of() : prior, objects);
        Check.probability("tau", tau);
        Check.probability("tau_human", tauHuman);
        Check.within("handovers", handovers, 1, 1000, "a count");
        Check.present("wrong_pick", wrongPick, "returned, removed or terminal");
        Check.present("ask", ask, "an object");
        Check.present("understanding", understanding, "an object");
        Check.present("perception", perception, "an object");
        Check.present("speech", speech, "an object");
        Check.present("gesture", gesture, "an object");
        Check.present("rewards", rewards, "an object");
        Check.present("pick", pick, "an object");
        Check.present("communicated", communicated, "an object");
        acts = Collections.unmodifiableMap(new LinkedHashMap<>(Check.present("acts", acts, "an object")));
        acts.forEach((verb, parameters) -> Check.present("acts." + verb, parameters, "an object"));
        frames = Collections.unmodifiableMap(new LinkedHashMap<>(Check.present("frames", frames, "an object")));
        adapters = Collections.unmodifiableMap(new LinkedHashMap<>(Check.present("adapters", adapters, "an object")));
        checkWords(objects, speech);
    }

    /** The defaults of MODEL with these objects. */
    public static DomainSpec of(String name, List<TableObject> objects) {
        Map<String, ActParameters> acts = new LinkedHashMap<>();
        acts.put("wait", new ActParameters(-1, 1, 0.4, 0.3, 0.5, 0.5));
        acts.put("look", new ActParameters(-1.3, 1, 0.5, 0.3, 0.3, 0.3));
        acts.put("point", new ActParameters(-1.8, 2, 0.5, 0.3, 0.9, 0.9));
        acts.put("ask", new ActParameters(-2.5, 2.5, 0.5, 0.3, 0.95, 0.95));
        acts.put("pick", new ActParameters(-1, 4, 0.5, 0.3, 0.1, 0.7));
        return new DomainSpec(name, "", BASE, objects, Map.of(), new Vector3(0, 0, 0.3), new Vector3(0.15, 1.4, 0.35),
                1, 0.95, 1, WrongPick.RETURNED, new AskParameters(AskSets.SINGLETONS),
                new Understanding(0.1, 0.162, 0.01), PerceptionParameters.EXACT,
                new SpeechParameters(0.2, 0.05, 0, 0, 0.01, List.of(0.5, 0.3, 0.2)),
                new GestureParameters(0.04, 0.05),
                new Rewards(50, -150, -2, 1, MatchScore.BRIER, 0.95), new PickParameters(3, 1),
                new CommunicatedParameters(3, MatchScore.LINEAR), acts, Map.of(), Map.of());
    }

    /** A copy with some fields changed: {@code spec.with(s -> s.tau = 0.9)}; checked like any other. */
    public DomainSpec with(Consumer<Fields> change) {
        Fields f = new Fields(this);
        change.accept(f);
        return new DomainSpec(f.name, f.description, f.variant, f.objects, f.prior, f.pointingOrigin, f.shoulder, f.tau, f.tauHuman,
                f.handovers, f.wrongPick, f.ask, f.understanding, f.perception, f.speech, f.gesture, f.rewards, f.pick,
                f.communicated, f.acts, f.frames, f.adapters);
    }

    /** The fields of a spec under change; see {@link DomainSpec} for what each means. Not thread safe. */
    public static final class Fields {
        public String name;
        public String description;
        public String variant;
        public List<TableObject> objects;
        public Map<String, Double> prior;
        public Vector3 pointingOrigin;
        public Vector3 shoulder;
        public double tau;
        public double tauHuman;
        public int handovers;
        public WrongPick wrongPick;
        public AskParameters ask;
        public Understanding understanding;
        public PerceptionParameters perception;
        public SpeechParameters speech;
        public GestureParameters gesture;
        public Rewards rewards;
        public PickParameters pick;
        public CommunicatedParameters communicated;
        /** Modifiable copy. */
        public Map<String, ActParameters> acts;
        public Map<String, Frame> frames;
        public Map<String, Adapter> adapters;

        private Fields(DomainSpec s) {
            name = s.name;
            description = s.description;
            variant = s.variant;
            objects = s.objects;
            prior = s.prior;
            pointingOrigin = s.pointingOrigin;
            shoulder = s.shoulder;
            tau = s.tau;
            tauHuman = s.tauHuman;
            handovers = s.handovers;
            wrongPick = s.wrongPick;
            ask = s.ask;
            understanding = s.understanding;
            perception = s.perception;
            speech = s.speech;
            gesture = s.gesture;
            rewards = s.rewards;
            pick = s.pick;
            communicated = s.communicated;
            acts = new LinkedHashMap<>(s.acts);
            frames = s.frames;
            adapters = s.adapters;
        }
    }

    /** The parameters of a type of act; throws {@link InvalidParameterException} if the file has none for it. */
    public ActParameters act(String verb) {
        return Check.present("acts." + verb, acts.get(verb), "the parameters of this act");
    }

    private static void checkObjects(List<TableObject> objects, Vector3 origin, Vector3 shoulder) {
        Set<String> names = new HashSet<>();
        for (int i = 0; i < objects.size(); i++) {
            TableObject o = objects.get(i);
            if (!names.add(o.name())) {
                throw new InvalidParameterException("objects[" + i + "].name", o.name(), "a name that no other object has");
            }
            checkApart(i, o, origin, "the robot's pointing_origin");
            checkApart(i, o, shoulder, "the human's shoulder");
        }
    }

    private static void checkApart(int i, TableObject o, Vector3 from, String what) {
        if (o.position().minus(from).norm() < Check.TOO_CLOSE) {
            throw new InvalidParameterException("objects[" + i + "].position", o.position(), "at least "
                    + Check.TOO_CLOSE + " m from " + what + ", or there is no direction to it");
        }
    }

    private static Map<String, Double> checkPrior(Map<String, Double> prior, List<TableObject> objects) {
        if (prior.isEmpty()) {
            return Map.of();
        }
        List<String> names = new ArrayList<>();
        objects.forEach(o -> names.add(o.name()));
        double sum = 0;
        for (Map.Entry<String, Double> e : prior.entrySet()) {
            String field = "prior." + e.getKey();
            if (!names.contains(e.getKey())) {
                throw new InvalidParameterException(field, e.getKey(), "the name of an object, one of " + names);
            }
            sum += Check.probability(field, Check.present(field, e.getValue(), "a probability"));
        }
        if (Math.abs(sum - 1) > ROUNDING) {
            throw new InvalidParameterException("prior", sum, "probabilities that sum to 1");
        }
        return Collections.unmodifiableMap(new TreeMap<>(prior));
    }

    private static void checkWords(List<TableObject> objects, SpeechParameters speech) {
        for (int i = 0; i < objects.size() && speech.alpha() == 0; i++) {
            if (objects.get(i).words().values().stream().mapToDouble(c -> c).sum() == 0) {
                throw new InvalidParameterException("objects[" + i + "].words", "expected at least one word with a "
                        + "count above 0, because with speech.alpha = 0 nothing that is said could mean this object");
            }
        }
    }
}
