package handover.io;

import com.fasterxml.jackson.core.JsonStreamContext;
import com.fasterxml.jackson.databind.JsonNode;
import handover.domain.InvalidParameterException;

/**
 * A place in a file, and how to complain about it.
 *
 * @param file as it was asked for
 * @param path keys joined by dots, list entries as {@code [index]}; empty for the file as a whole
 */
record Place(String file, String path) {
    private static final int LONGEST_SHOWN = 60;

    static Place of(String file) {
        return new Place(file, "");
    }

    /** Where a parser is. */
    static Place of(String file, JsonStreamContext context) {
        if (context.inRoot()) {
            return of(file);
        }
        Place outer = of(file, context.getParent());
        return context.inArray() ? outer.at(context.getCurrentIndex()) : outer.key(context.getCurrentName());
    }

    Place key(String key) {
        return new Place(file, (path.isEmpty() ? "" : path + ".") + shown(key));
    }

    Place at(int index) {
        return new Place(file, path + "[" + index + "]");
    }

    DomainFileException error(String problem) {
        return error(problem, null);
    }

    DomainFileException error(String problem, Throwable cause) {
        return new DomainFileException(file, path, problem, cause);
    }

    DomainFileException expected(String what, JsonNode got) {
        return error("expected " + what + ", got " + shown(got.toString()));
    }

    /** What a record refuses, said of the place where the file gives that record. */
    DomainFileException invalid(InvalidParameterException e) {
        Place field = e.field().isEmpty() ? this : key(e.field());
        return field.error(e.problem(), e);
    }

    /** A text cut to a length that fits in a message. */
    static String shown(String text) {
        return text.length() <= LONGEST_SHOWN ? text : text.substring(0, LONGEST_SHOWN) + "...";
    }
}
