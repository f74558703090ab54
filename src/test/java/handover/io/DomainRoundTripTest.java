package handover.io;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.fasterxml.jackson.databind.node.ObjectNode;
import handover.domain.ActParameters;
import handover.domain.Adapter;
import handover.domain.AskParameters;
import handover.domain.AskSets;
import handover.domain.DomainSpec;
import handover.domain.Frame;
import handover.domain.GestureParameters;
import handover.domain.Rewards;
import handover.domain.SpeechParameters;
import handover.domain.TableObject;
import handover.domain.Understanding;
import handover.domain.WrongPick;
import handover.math.MatchScore;
import handover.math.Vector3;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Set;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;

/** Whatever can be a domain survives being written and read, to the last bit, and is valid for an editor. */
class DomainRoundTripTest {
    private static final Schema SCHEMA = Schema.of("domain");

    @Property(tries = 300)
    void whatIsWrittenIsRead(@ForAll("specs") DomainSpec spec) {
        ObjectNode json = DomainFiles.toJson(spec);
        assertEquals(spec, DomainFiles.fromJson(json, "x"));
        byte[] text = json.toPrettyString().getBytes(StandardCharsets.UTF_8);
        DomainSpec read = DomainFiles.fromJson(JsonText.parse(text, "x"), "x");
        assertEquals(spec, read);
        assertEquals(DomainFiles.hash(spec), DomainFiles.hash(read));
        assertEquals(Set.of(), SCHEMA.faults(json));
    }

    @Provide
    Arbitrary<DomainSpec> specs() {
        Arbitrary<DomainSpec> objects = objects().map(o -> DomainSpec.of("d", o));
        Arbitrary<DomainSpec> people = Combinators
                .combine(objects, understanding(), speech(), between(1e-6, 1e3), probability(), between(20, 100))
                .as((spec, u, s, variance, outliers, height) -> spec.with(f -> {
                    f.understanding = u;
                    f.speech = s;
                    f.gesture = new GestureParameters(variance, outliers);
                    f.shoulder = new Vector3(-0.0, 0, height);
                }));
        Arbitrary<DomainSpec> task = Combinators
                .combine(people, rewards(), Arbitraries.of(AskSets.class), Arbitraries.of(WrongPick.class),
                        Arbitraries.integers().between(1, 1000), probability(), Arbitraries.strings())
                .as((spec, r, sets, wrong, handovers, tau, description) -> spec.with(f -> {
                    f.rewards = r;
                    f.ask = new AskParameters(sets);
                    f.wrongPick = wrong;
                    f.handovers = handovers;
                    f.tau = tau;
                    f.description = description;
                    f.prior = Map.of(spec.objects().get(0).name(), 1.0);
                }));
        return Combinators.combine(task, act(), Arbitraries.of("wait", "pick", "nod"))
                .as((spec, act, verb) -> spec.with(f -> {
                    f.acts.put(verb, act);
                    f.frames = Map.of("camera", new Frame(List.of(List.of(0.0, -1.0, 0.0), List.of(0.6, 0.0, -0.8),
                            List.of(0.8, 0.0, 0.6)), new Vector3(act.reward() / 1e6, -0.0, 2)));
                    f.adapters = Map.of(verb, new Adapter(Adapter.Type.SPEECH, Map.of("text", "a.Text"), Map.of("side", verb)));
                }));
    }

    private static Arbitrary<List<TableObject>> objects() {
        Arbitrary<Map<String, Double>> words = Arbitraries.maps(
                Arbitraries.of("red", "cup", "café", "赤", "x-ray", "o'clock"), between(0, 1e9)).ofMaxSize(4);
        Arbitrary<Vector3> positions = Combinators.combine(between(-100, 100), between(-100, 100), between(1, 10))
                .as(Vector3::new);
        Arbitrary<String> labels = Arbitraries.strings().filter(s -> !s.isBlank());
        return Combinators.combine(Arbitraries.strings().withChars("aZ09_.-").ofMinLength(1), positions, words, labels)
                .as(TableObject::new).list().uniqueElements(TableObject::name).ofMinSize(1).ofMaxSize(5);
    }

    private static Arbitrary<Understanding> understanding() {
        return Combinators.combine(between(1e-4, 3), between(1e-4, 3), probability()).as(Understanding::new);
    }

    private static Arbitrary<SpeechParameters> speech() {
        Arbitrary<List<Double>> counts = Arbitraries.integers().between(1, 9).list().ofMinSize(1).ofMaxSize(5)
                .map(weights -> {
                    double sum = weights.stream().mapToInt(w -> w).sum();
                    return weights.stream().map(w -> w / sum).toList();
                });
        return Combinators.combine(between(1e-3, 1e6), probability(), probability(), probability(), probability(), counts)
                .as(SpeechParameters::new);
    }

    private static Arbitrary<Rewards> rewards() {
        return Combinators.combine(between(-1e6, 1e6), between(-1e6, 1e6), between(-1e6, 1e6), between(0, 1e6),
                Arbitraries.of(MatchScore.class), between(0, 0.999)).as(Rewards::new);
    }

    private static Arbitrary<ActParameters> act() {
        return Combinators.combine(between(-1e6, 1e6), between(0, 3600), probability(), probability(), probability(),
                probability()).as(ActParameters::new);
    }

    private static Arbitrary<Double> probability() {
        return between(0, 1);
    }

    private static Arbitrary<Double> between(double low, double high) {
        return Arbitraries.doubles().between(low, high).ofScale(17);
    }
}
