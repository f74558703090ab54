package handover.domain;

import handover.math.MatchScore;
import handover.math.Vector3;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;

/** Domains of all kinds for jqwik: 1 to 8 objects, every policy, every parameter also at the ends of its range. */
public final class AnyDomain {
    private static final List<String> WORDS = List.of("ball", "blue", "cup", "metal", "red", "round", "small");

    private AnyDomain() {}

    /** Any base domain. */
    public static Arbitrary<DomainSpec> specs() {
        return Arbitraries.integers().between(1, 8).flatMap(AnyDomain::specs);
    }

    private static Arbitrary<DomainSpec> specs(int n) {
        Arbitrary<List<TableObject>> objects = objectWords().list().ofSize(n).flatMap(words ->
                positions(n).map(at -> objects(words, at)));
        return Combinators.combine(objects, speech(), gesture(), understanding(), course(), scores()).as(
                (o, speech, gesture, understanding, course, score) -> DomainSpec.of("any", o).with(s -> {
                    s.speech = speech;
                    s.gesture = gesture;
                    s.understanding = understanding;
                    s.tau = course.tau;
                    s.tauHuman = course.tauHuman;
                    s.handovers = course.handovers;
                    s.wrongPick = course.wrongPick;
                    s.ask = new AskParameters(course.sets);
                    s.rewards = new Rewards(50, -150, -2, 0.7, score, 0.95);
                }));
    }

    private record Course(double tau, double tauHuman, int handovers, WrongPick wrongPick, AskSets sets) {}

    private static Arbitrary<Course> course() {
        return Combinators.combine(Arbitraries.of(1.0, 0.9, 0.5), Arbitraries.of(1.0, 0.95, 0.5),
                Arbitraries.integers().between(1, 4), Arbitraries.of(WrongPick.class), Arbitraries.of(AskSets.class))
                .as(Course::new);
    }

    private static Arbitrary<MatchScore> scores() {
        return Arbitraries.of(MatchScore.class);
    }

    private static Arbitrary<SpeechParameters> speech() {
        return Combinators.combine(Arbitraries.of(0.0, 0.2, 1.0), Arbitraries.of(0.05, 0.5, 1.0),
                Arbitraries.of(0.0, 0.5, 1.0), Arbitraries.of(0.0, 0.3, 1.0), Arbitraries.of(0.01, 0.2)).as(
                        (alpha, negation, contrast, surprise, error) -> new SpeechParameters(alpha, negation, contrast,
                                surprise, error, List.of(0.5, 0.3, 0.2)));
    }

    private static Arbitrary<GestureParameters> gesture() {
        return Combinators.combine(Arbitraries.of(0.01, 0.04, 0.4, 3.0), Arbitraries.of(0.0, 0.05, 1.0))
                .as(GestureParameters::new);
    }

    private static Arbitrary<Understanding> understanding() {
        return Combinators.combine(Arbitraries.doubles().between(0.08, 1), Arbitraries.doubles().between(0.08, 1),
                Arbitraries.of(0.01, 0.3)).as(Understanding::new);
    }

    /** Counts of the words; at least one is not 0. */
    private static Arbitrary<Map<String, Double>> objectWords() {
        return Combinators.combine(Arbitraries.of(0.0, 0.0, 1.0, 2.0, 11.0).list().ofSize(WORDS.size()),
                Arbitraries.of(WORDS)).as((counts, atLeast) -> {
                    Map<String, Double> words = new TreeMap<>();
                    for (int w = 0; w < counts.size(); w++) {
                        if (counts.get(w) > 0) {
                            words.put(WORDS.get(w), counts.get(w));
                        }
                    }
                    words.putIfAbsent(atLeast, 1.5);
                    return words;
                });
    }

    private static Arbitrary<List<Vector3>> positions(int n) {
        return Combinators.combine(Arbitraries.doubles().between(-0.8, 0.8), Arbitraries.doubles().between(0.3, 0.9),
                Arbitraries.doubles().between(-0.1, 0.1)).as(Vector3::new).list().ofSize(n);
    }

    /** Labels are a name that is in no vocabulary, one word, or two words, of those that people use for the object. */
    private static List<TableObject> objects(List<Map<String, Double>> words, List<Vector3> at) {
        List<TableObject> all = new ArrayList<>();
        for (int i = 0; i < words.size(); i++) {
            List<String> own = List.copyOf(words.get(i).keySet());
            String label = i % 3 == 0 ? null : i % 3 == 1 ? own.get(0) : own.get(0) + ", " + own.get(own.size() - 1);
            all.add(new TableObject("thing_" + i, at.get(i), words.get(i), label));
        }
        return all;
    }

    /** A random distribution over n outcomes, sometimes with zeros. */
    public static double[] simplex(int n, Random random) {
        double[] p = new double[n];
        double sum = 0;
        for (int i = 0; i < n; i++) {
            p[i] = random.nextInt(4) == 0 && i > 0 ? 0 : -Math.log(1 - random.nextDouble());
            sum += p[i];
        }
        for (int i = 0; i < n; i++) {
            p[i] /= sum;
        }
        return p;
    }

    /** One of a list. */
    public static <T> T oneOf(List<T> all, Random random) {
        return all.get(random.nextInt(all.size()));
    }

    /** So many words of the domain's vocabulary. */
    public static List<String> words(HandoverDomain domain, int count, Random random) {
        List<String> words = new ArrayList<>();
        for (int k = 0; k < count; k++) {
            words.add(oneOf(domain.vocabulary().words(), random));
        }
        return words;
    }

    /** One to {@code most} words of the domain's vocabulary. */
    public static List<String> someWords(HandoverDomain domain, int most, Random random) {
        return words(domain, 1 + random.nextInt(most), random);
    }
}
