package handover.io;

import com.fasterxml.jackson.databind.ObjectWriter;
import com.fasterxml.jackson.databind.SerializationFeature;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Map;

/**
 * A file of measurements: an object of texts, numbers, lists and objects as pretty JSON. A reader never sees half of it.
 *
 * @param path is replaced at each {@link #write}
 */
public record BenchFile(Path path) {
    private static final ObjectWriter WRITER = JsonMapper.builder().enable(SerializationFeature.INDENT_OUTPUT).build().writer();

    /** Writes everything anew; not modified. */
    public void write(Map<String, ?> content) throws IOException {
        Path whole = path.toAbsolutePath();
        Files.createDirectories(whole.getParent());
        Path draft = whole.resolveSibling(whole.getFileName() + ".tmp");
        try {
            Files.writeString(draft, WRITER.writeValueAsString(content) + "\n");
            Files.move(draft, whole, StandardCopyOption.REPLACE_EXISTING);
        } catch (IOException e) {
            throw NamedOutput.named(path, e);
        } finally {
            Files.deleteIfExists(draft);
        }
    }
}
