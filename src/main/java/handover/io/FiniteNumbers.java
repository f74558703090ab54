package handover.io;

import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.util.JsonParserDelegate;
import java.io.IOException;

/** A parser that refuses NaN, Infinity and what is read as infinite (1e999) while it still knows how it was written. */
final class FiniteNumbers extends JsonParserDelegate {
    private final String file;

    FiniteNumbers(JsonParser parser, String file) {
        super(parser);
        this.file = file;
    }

    @Override
    public double getDoubleValue() throws IOException {
        double value = super.getDoubleValue();
        if (!Double.isFinite(value)) {
            throw Place.of(file, getParsingContext())
                    .error("expected a finite number, got " + Place.shown(getText()));
        }
        return value;
    }
}
