package handover.io;

import static handover.io.BadDomains.quoted;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import com.fasterxml.jackson.databind.node.DoubleNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What is wrong with a file is said with file, path, value and expectation. */
class BadDomainFileTest {
    @TempDir
    Path folder;

    @ParameterizedTest
    @MethodSource("handover.io.BadDomains#all")
    void saysExactlyWhatIsWrong(BadDomains.Bad bad) throws IOException {
        Path file = Files.writeString(folder.resolve("bad.json"), bad.text());
        assertEquals(file + ": " + bad.message(), message(file.toString()));
    }

    @Test
    void theFileThatTheBadOnesAreMadeOfIsGood() throws IOException {
        Path file = Files.writeString(folder.resolve("good.json"), quoted(BadDomains.GOOD));
        assertEquals("x", DomainFiles.read(file.toString()).name());
    }

    @Test
    void theExceptionKnowsFileAndPath() {
        ObjectNode json = JsonNodeFactory.instance.objectNode().put("name", 3);
        DomainFileException e = assertThrows(DomainFileException.class, () -> DomainFiles.fromJson(json, "a message"));
        assertEquals("a message", e.file());
        assertEquals("name", e.path());
        assertEquals("expected text in double quotes, got 3", e.problem());
    }

    @ParameterizedTest
    @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY})
    void treesThatWereNeverTextMayNotHaveThemEither(double value) {
        ObjectNode json = BadDomains.json(BadDomains.GOOD).deepCopy();
        json.set("tau", DoubleNode.valueOf(value));
        DomainFileException e = assertThrows(DomainFileException.class, () -> DomainFiles.fromJson(json, "x"));
        assertEquals("tau", e.path());
    }

    @Test
    void unknownNamesListWhatThereIs() {
        assertEquals("bowls: there is no such file, and no shipped domain of this name; available are bowls-and-spoons, "
                + "bowls-communicated, bowls-incremental, bowls-incremental-communicated, bowls-nested, kitchen-20, table-line-5, "
                + "table-line-6, table-line-6-communicated, table-line-6-incremental", message("bowls"));
        assertTrue(message("../domains/kitchen-20").startsWith("../domains/kitchen-20: there is no such file"));
        assertTrue(message("a\0b").contains("there is no such file"));
        assertTrue(message(folder.toString()).startsWith(folder + ": is a directory, not a file"));
    }

    @Test
    void filesAreOfReasonableSize() throws IOException {
        Path file = folder.resolve("large.json");
        try (RandomAccessFile large = new RandomAccessFile(file.toFile(), "rw")) {
            large.setLength(DomainSource.LARGEST + 1);
        }
        assertEquals(file + ": larger than 16 MiB, which no domain file is", message(file.toString()));
    }

    @Test
    void filesAreUtf8() throws IOException {
        Path file = Files.write(folder.resolve("latin1.json"), new byte[] {'"', (byte) 0xe9, '"'});
        assertEquals(file + ": expected text in UTF-8, got bytes that are not", message(file.toString()));
    }

    @Test
    void aByteOrderMarkDoesNoHarm() throws IOException {
        Path file = Files.writeString(folder.resolve("bom.json"), "\uFEFF" + quoted(BadDomains.GOOD));
        assertEquals("x", DomainFiles.read(file.toString()).name());
    }

    @Test
    void filesThatMayNotBeReadAreNamed() throws IOException {
        Path file = Files.writeString(folder.resolve("secret.json"), "{}");
        assumeFalse(!file.toFile().setReadable(false) || Files.isReadable(file), "the superuser may read everything");
        assertEquals(file + ": this file may not be read: permission denied", message(file.toString()));
    }

    private static String message(String nameOrPath) {
        return assertThrows(DomainFileException.class, () -> DomainFiles.read(nameOrPath)).getMessage();
    }
}
