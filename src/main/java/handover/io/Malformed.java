package handover.io;

import com.fasterxml.jackson.core.JsonLocation;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.exc.StreamConstraintsException;
import com.fasterxml.jackson.core.io.JsonEOFException;
import com.fasterxml.jackson.databind.exc.MismatchedInputException;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * Text that is not JSON, in words for people who do not know the parser.
 *
 * @param location where it stops being JSON
 * @param text of the whole file
 * @param file what messages call it
 */
record Malformed(JsonLocation location, String text, String file) {
    private static final int LONGEST_SNIPPET = 20;
    /** A part of the parser's message, and what it means; the first that fits counts. */
    private static final Map<String, String> EXPECTED = new LinkedHashMap<>();

    static {
        EXPECTED.put("comment", "JSON, which has no comments");
        EXPECTED.put("colon", "a colon between key and value");
        EXPECTED.put("field name", "a key in double quotes");
        EXPECTED.put("comma", "a comma or a closing bracket");
        EXPECTED.put("no open", "the end of the file");
        EXPECTED.put("close marker", "a closing bracket of the other kind");
        EXPECTED.put("numeric value", "a number such as 0.5 or -2e3");
        EXPECTED.put("unquoted character", "text in double quotes on one line");
        EXPECTED.put("escape", "a character that may follow a backslash");
        EXPECTED.put("token", "a value: a number, text in double quotes, [...] or {...}");
        EXPECTED.put("valid value", "a value: a number, text in double quotes, [...] or {...}");
    }

    /** The exception for what the parser reports. */
    static DomainFileException explain(JsonProcessingException e, JsonParser parser, String text, String file) {
        JsonLocation location = e.getLocation() == null ? parser.currentLocation() : e.getLocation();
        Malformed malformed = new Malformed(location, text, file);
        if (e instanceof JsonEOFException) {
            return malformed.says("the file ends here, but not everything that was opened is closed");
        } else if (e instanceof StreamConstraintsException) {
            boolean deep = parser.getParsingContext().getNestingDepth() > JsonText.DEEPEST;
            return malformed.says(deep ? "nested more than " + JsonText.DEEPEST + " levels deep"
                    : "a number or a key that is too long");
        } else if (e instanceof MismatchedInputException) {
            return Place.of(file, parser.getParsingContext()).error("the key is there twice, again in " + malformed.where());
        }
        return malformed.error(EXPECTED.entrySet().stream().filter(m -> e.getOriginalMessage().contains(m.getKey()))
                .map(Map.Entry::getValue).findFirst().orElse("JSON"));
    }

    DomainFileException error(String expected) {
        return says("expected " + expected + ", got " + snippet());
    }

    private DomainFileException says(String problem) {
        return Place.of(file).error(where() + ": " + problem);
    }

    private String where() {
        return "line " + location.getLineNr() + ", column " + location.getColumnNr();
    }

    private String snippet() {
        int from = (int) Math.min(location.getCharOffset(), text.length());
        String rest = text.substring(from, Math.min(text.length(), from + LONGEST_SNIPPET));
        String line = rest.lines().findFirst().orElse("").strip();
        return line.isEmpty() ? "the end of the line" : line;
    }
}
