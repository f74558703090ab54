package handover.tabular;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.Answer;
import handover.domain.Gesture;
import handover.domain.HandoverDomain;
import handover.domain.HumanModel;
import handover.domain.Observation;
import handover.domain.PickSignal;
import handover.domain.Scene;
import handover.domain.Speech;
import handover.domain.Utterance;
import handover.io.DomainFiles;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The flat model predicts what the domain does, as far as it keeps what is sensed. */
class FlatHandoverTest {
    private static final double[] BELIEF = {0.4, 0.3, 0.2, 0.1};

    private final HandoverDomain domain = DomainFiles.load("bowls-and-spoons");
    private final Scene scene = domain.start();

    /** P(wanted) in the flat model after an act and an observation. */
    private double[] flatFilter(FlatHandover flat, Act act, Observation o) {
        TabularPomdp m = flat.pomdp();
        double[] b = new double[m.states().size()];
        for (int i = 0; i < BELIEF.length; i++) {
            b[flat.startState(i)] = BELIEF[i];
        }
        TabularBelief after = new TabularBelief(b, 0).after(m, flat.act(act), flat.observation(o));
        assertEquals(0, after.unforeseen());
        double[] wanted = new double[BELIEF.length];
        for (int s = 0; s < b.length; s++) {
            for (int i = 0; i < wanted.length; i++) {
                wanted[i] += m.states().get(s).startsWith(scene.objects().get(i).name()) ? after.probabilities()[s] : 0;
            }
        }
        return wanted;
    }

    private static Observation heard(Answer answer, String... words) {
        boolean silent = answer == Answer.NONE && words.length == 0;
        return new Observation(silent ? null : Speech.of(new Utterance(answer, List.of(words), List.of(), List.of())), null,
                PickSignal.NONE);
    }

    @ParameterizedTest
    @EnumSource(value = FlatHandover.Detail.class, names = {"WISH", "REFERENCE"})
    void thePosteriorAfterWordsAndAnswersIsThatOfTheFilter(FlatHandover.Detail detail) {
        FlatHandover flat = new FlatHandover(domain, detail, 0);
        for (Act act : List.of(Act.WAIT, Act.of("ASK", "color_bowl"), Act.of("POINT", "silver_spoon"), Act.of("LOOK", "metal_bowl"))) {
            for (Observation o : List.of(heard(Answer.NONE), heard(Answer.YES), heard(Answer.NO, "bowl"), heard(Answer.NONE, "shiny"))) {
                if (act.equals(Act.WAIT) && o.speech() != null && o.speech().answer() != Answer.NONE) {
                    continue;
                }
                double[] exact = HandoverBelief.of(domain.task(scene), BELIEF, new double[] {0.25, 0.25, 0.25, 0.25}).after(act).given(o)
                        .probabilities();
                assertArrayEquals(exact, flatFilter(flat, act, o), 1e-9, act + ", " + o);
            }
        }
    }

    @Test
    void aRejectedPickTellsTheSame() {
        FlatHandover flat = new FlatHandover(domain, FlatHandover.Detail.REFERENCE, 0);
        Observation o = new Observation(null, null, PickSignal.REJECTED);
        Act pick = Act.of("PICK", "metal_bowl");
        assertArrayEquals(HandoverBelief.of(domain.task(scene), BELIEF, BELIEF).after(pick).given(o).probabilities(),
                flatFilter(flat, pick, o), 1e-9);
    }

    /** 20,000 gestures for each object; a share is off by less than 0.018 but in one of a million (5 standard errors). */
    @Test
    void sectorsAreAsProbableAsGesturesDrawnFromTheDomain() {
        GestureSectors sectors = new GestureSectors(scene);
        SplittableRandom random = new SplittableRandom(20261122);
        for (int i = 0; i < scene.size(); i++) {
            double[] share = new double[scene.size()];
            for (int k = 0; k < 20_000; k++) {
                Gesture g = HumanModel.sampleGesture(scene, i, random);
                share[sectors.sector(g.direction())] += 1 / 20_000.0;
            }
            for (int j = 0; j < share.length; j++) {
                assertEquals(share[j], sectors.probability(i, j), 0.018, "meant " + i + ", sector " + j);
            }
            assertEquals(1, sectors.mass(i), 1e-3);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"bowls-and-spoons", "bowls-incremental", "bowls-communicated", "table-line-5"})
    void rowsSumToOneAndTheEndIsTheEnd(String name) {
        FlatHandover flat = new FlatHandover(DomainFiles.load(name), FlatHandover.Detail.WISH, 0);
        TabularPomdp m = flat.pomdp();
        for (int a = 0; a < m.acts().size(); a++) {
            for (int s = 0; s < m.states().size(); s++) {
                double next = 0;
                double seen = 0;
                for (int k = 0; k < m.states().size(); k++) {
                    next += m.transition(a, s, k);
                }
                for (int o = 0; o < m.observations().size(); o++) {
                    seen += m.observation(a, s, o);
                }
                assertEquals(1, next, 1e-9);
                assertEquals(1, seen, 1e-9);
            }
        }
        assertEquals(List.of("over"), m.states().stream().filter(s -> m.terminal(m.states().indexOf(s))).toList());
    }

    @Test
    void picksEarnWhatTheDomainPays() {
        FlatHandover flat = new FlatHandover(domain, FlatHandover.Detail.WISH, 0);
        int pick = flat.act(Act.of("PICK", "metal_bowl"));
        double right = flat.pomdp().reward(pick, flat.startState(0));
        double wrong = flat.pomdp().reward(pick, flat.startState(1));
        assertTrue(right > 48 && right < 50 && wrong < -149, right + ", " + wrong);
    }

    @Test
    void whatTheTableDoesNotOfferIsRefused() {
        FlatHandover flat = new FlatHandover(domain, FlatHandover.Detail.WISH, 0);
        assertThrows(IllegalArgumentException.class, () -> flat.act(Act.of("PICK", "moon")));
        assertThrows(IllegalArgumentException.class, () -> flat.observation(new Observation(null, null, PickSignal.MOVING)));
    }
}
