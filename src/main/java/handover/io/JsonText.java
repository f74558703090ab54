package handover.io;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.StreamReadConstraints;
import com.fasterxml.jackson.core.json.JsonReadFeature;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;

/** Bytes to a JSON tree, strictly: one value, UTF-8, no key twice, finite numbers only. Thread safe. */
final class JsonText {
    static final int DEEPEST = 50;
    private static final String BYTE_ORDER_MARK = "\uFEFF";
    /** NaN and Infinity are let through to {@link FiniteNumbers}, which says where they are. */
    private static final JsonMapper MAPPER = mapper(DEEPEST);
    /** A line of a log may hold a message of the largest depth. */
    private static final JsonMapper LOG_MAPPER = mapper(DEEPEST + 2);

    private JsonText() {}

    private static JsonMapper mapper(int deepest) {
        return JsonMapper
                .builder(JsonFactory.builder().streamReadConstraints(
                        StreamReadConstraints.builder().maxNestingDepth(deepest).build()).build())
                .enable(JsonReadFeature.ALLOW_NON_NUMERIC_NUMBERS)
                .enable(DeserializationFeature.FAIL_ON_READING_DUP_TREE_KEY)
                .build();
    }

    /**
     * The one JSON value that a file holds; a byte order mark before it is skipped.
     *
     * @param file what messages call it
     * @throws DomainFileException with line and column, or with the path of a bad number or of a key given twice
     */
    static JsonNode parse(byte[] bytes, String file) {
        return parse(MAPPER, decode(bytes, file), file);
    }

    /** The same of a line of a log. */
    static JsonNode parseLog(byte[] bytes, String file) {
        return parse(LOG_MAPPER, decode(bytes, file), file);
    }

    private static JsonNode parse(JsonMapper mapper, String text, String file) {
        try (JsonParser parser = new FiniteNumbers(mapper.createParser(text), file)) {
            return parse(mapper, parser, text, file);
        } catch (IOException e) {
            throw new UncheckedIOException("reading from memory cannot fail", e);
        }
    }

    private static JsonNode parse(JsonMapper mapper, JsonParser parser, String text, String file) throws IOException {
        try {
            JsonNode tree = mapper.readTree(parser);
            if (tree == null) {
                throw Place.of(file).error("expected a JSON value, got nothing");
            }
            if (parser.nextToken() != null) {
                throw new Malformed(parser.currentTokenLocation(), text, file).error("the end of the file");
            }
            return tree;
        } catch (JsonProcessingException e) {
            throw Malformed.explain(e, parser, text, file);
        }
    }

    static String decode(byte[] bytes, String file) {
        try {
            String text = StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes)).toString();
            return text.startsWith(BYTE_ORDER_MARK) ? text.substring(1) : text;
        } catch (CharacterCodingException e) {
            throw Place.of(file).error("expected text in UTF-8, got bytes that are not", e);
        }
    }
}
