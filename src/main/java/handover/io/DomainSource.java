package handover.io;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.URISyntaxException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * The bytes of a file and what messages call it.
 *
 * @param name the file's path, or {@code domains/NAME.json} of a shipped domain
 */
record DomainSource(String name, byte[] bytes) {
    static final int LARGEST = 16 << 20;
    private static final String FOLDER = "domains";
    private static final String ENDING = ".json";
    private static final Pattern NAME = Pattern.compile("[A-Za-z0-9_.-]+");

    /** The file at a path, else the shipped domain of that name. Throws {@link DomainFileException} if there is neither. */
    static DomainSource find(String nameOrPath) {
        Path file = path(nameOrPath);
        if (file != null && Files.exists(file) && !Files.isDirectory(file)) {
            return ofFile(file);
        }
        if (NAME.matcher(nameOrPath).matches()) {
            Path local = Path.of(FOLDER, nameOrPath + ENDING);
            if (Files.exists(local)) {
                return ofFile(local);
            }
            String resource = FOLDER + "/" + nameOrPath + ENDING;
            InputStream shipped = DomainSource.class.getResourceAsStream("/" + resource);
            if (shipped != null) {
                return read(resource, shipped);
            }
        }
        String found = file != null && Files.isDirectory(file) ? "is a directory, not a file" : "there is no such file";
        throw Place.of(nameOrPath).error(found + ", and no shipped domain of this name; available are "
                + String.join(", ", available()));
    }

    /** A file, of at most {@link #LARGEST} bytes. */
    static DomainSource ofFile(Path file) {
        Place place = Place.of(file.toString());
        if (Files.isDirectory(file)) {
            throw place.error("is a directory, not a file");
        }
        try {
            return read(file.toString(), Files.newInputStream(file));
        } catch (NoSuchFileException e) {
            throw place.error("there is no such file", e);
        } catch (AccessDeniedException e) {
            throw place.error("this file may not be read: permission denied", e);
        } catch (IOException e) {
            throw place.error("cannot be read: " + e.getMessage(), e);
        }
    }

    private static DomainSource read(String name, InputStream open) {
        try (InputStream in = open) {
            byte[] bytes = in.readNBytes(LARGEST + 1);
            if (bytes.length > LARGEST) {
                throw Place.of(name).error("larger than 16 MiB, which no domain file is");
            }
            return new DomainSource(name, bytes);
        } catch (IOException e) {
            throw Place.of(name).error("cannot be read: " + e.getMessage(), e);
        }
    }

    /** Names of the domains in the working directory and of those that come with the toolkit, in alphabetical order. */
    static SortedSet<String> available() {
        SortedSet<String> names = new TreeSet<>();
        try {
            addNames(Path.of(FOLDER), names);
            Path classes = Path.of(DomainSource.class.getProtectionDomain().getCodeSource().getLocation().toURI());
            if (Files.isDirectory(classes)) {
                addNames(classes.resolve(FOLDER), names);
            } else {
                try (FileSystem jar = FileSystems.newFileSystem(classes)) {
                    addNames(jar.getPath(FOLDER), names);
                }
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        } catch (URISyntaxException e) {
            throw new IllegalStateException(e);
        }
        return names;
    }

    private static void addNames(Path folder, SortedSet<String> names) throws IOException {
        if (Files.isDirectory(folder)) {
            try (Stream<Path> files = Files.list(folder)) {
                files.map(f -> f.getFileName().toString()).filter(f -> f.endsWith(ENDING))
                        .forEach(f -> names.add(f.substring(0, f.length() - ENDING.length())));
            }
        }
    }

    private static Path path(String nameOrPath) {
        try {
            return Path.of(nameOrPath);
        } catch (InvalidPathException e) {
            return null;
        }
    }
}
