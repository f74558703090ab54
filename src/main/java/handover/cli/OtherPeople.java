package handover.cli;

import handover.domain.ActParameters;
import handover.domain.DomainSpec;
import handover.domain.GestureParameters;
import handover.domain.SpeechParameters;
import java.util.List;

/** People other than a domain models, with whom beliefs come about that the model alone would seldom lead to. */
final class OtherPeople {
    private static final double QUIET = 0.5;
    private static final double SLOPPY = 5;
    private static final double OUTLIERS = 0.2;
    private static final double CONTRARY = 0.2;
    private static final double FICKLE = 0.95;

    private OtherPeople() {}

    /** Quiet ones, sloppy pointers, and contrary ones who change their minds. */
    static List<DomainSpec> of(DomainSpec model) {
        return List.of(quiet(model), sloppy(model), contrary(model));
    }

    private static DomainSpec quiet(DomainSpec model) {
        return model.with(s -> s.acts.replaceAll((verb, a) -> new ActParameters(a.reward(), a.duration(), QUIET * a.speechRate(),
                QUIET * a.gestureRate(), QUIET * a.answerIfMatch(), QUIET * a.answerIfMiss())));
    }

    private static DomainSpec sloppy(DomainSpec model) {
        GestureParameters g = model.gesture();
        return model.with(s -> s.gesture = new GestureParameters(Math.min(1, SLOPPY * g.variance()), Math.max(OUTLIERS, g.outliers())));
    }

    private static DomainSpec contrary(DomainSpec model) {
        SpeechParameters p = model.speech();
        return model.with(s -> {
            s.tau = Math.min(FICKLE, model.tau());
            s.speech = new SpeechParameters(p.alpha(), p.negationFactor(), p.contrast(), p.surprise(),
                    Math.max(CONTRARY, p.answerError()), p.wordCounts());
        });
    }
}
