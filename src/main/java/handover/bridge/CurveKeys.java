package handover.bridge;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.zeromq.ZMQ;

/**
 * A key pair for CURVE as text in Z85, 40 characters each, in the files that ZeroMQ's own tools use: {@code NAME.key} with the
 * public key, {@code NAME.key_secret} with both and mode 600.
 *
 * @param secret null if the file has only the public one
 */
public record CurveKeys(String publicKey, String secret) {
    private static final String PUBLIC_ENDING = ".key";
    private static final String SECRET_ENDING = ".key_secret";
    private static final String MODE = "rw-------";
    private static final long LARGEST = 64 * 1024;
    private static final Pattern KEY = Pattern.compile("(?m)^\\s*(public|secret)-key\\s*=\\s*\"?([^\"\\r\\n]*?)\"?\\s*$");
    private static final Pattern Z85 = Pattern.compile("[0-9a-zA-Z.\\-:+=^!/*?&<>()\\[\\]{}@%$#]{40}");

    /** New keys, in two new files next to each other. Throws {@link BridgeException} if there are such files already. */
    public static CurveKeys generate(Path name) throws IOException {
        ZMQ.Curve.KeyPair pair = ZMQ.Curve.generateKeyPair();
        Path publicFile = Path.of(name + PUBLIC_ENDING);
        Path secretFile = Path.of(name + SECRET_ENDING);
        for (Path file : List.of(publicFile, secretFile)) {
            if (Files.exists(file)) {
                throw new BridgeException(file + ": there is such a file already, and it will not be overwritten", null);
            }
        }
        write(secretFile, "metadata\ncurve\n    public-key = \"" + pair.publicKey + "\"\n    secret-key = \"" + pair.secretKey
                + "\"\n", true);
        write(publicFile, "metadata\ncurve\n    public-key = \"" + pair.publicKey + "\"\n", false);
        return new CurveKeys(pair.publicKey, pair.secretKey);
    }

    private static void write(Path file, String text, boolean secret) throws IOException {
        boolean posix = file.getFileSystem().supportedFileAttributeViews().contains("posix");
        FileAttribute<?>[] mode = secret && posix
                ? new FileAttribute<?>[] {PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString(MODE))}
                : new FileAttribute<?>[0];
        Files.createFile(file, mode);
        Files.writeString(file, text, StandardOpenOption.WRITE);
    }

    /** The keys of a server. Throws {@link BridgeException} if the file has none, or if others may read it. */
    public static CurveKeys server(Path file) throws IOException {
        CurveKeys keys = read(file);
        if (keys.secret == null) {
            throw new BridgeException(file + ": expected a secret key in it; bridge keygen makes one", null);
        } else if (file.getFileSystem().supportedFileAttributeViews().contains("posix")) {
            Set<PosixFilePermission> mode = Files.getPosixFilePermissions(file);
            if (mode.stream().anyMatch(p -> !p.name().startsWith("OWNER"))) {
                throw new BridgeException(file + ": others may read this secret key; expected mode 600, got "
                        + PosixFilePermissions.toString(mode), null);
            }
        }
        return keys;
    }

    /** The public keys of all files of a folder that end in {@code .key}. Throws {@link BridgeException} if there are none. */
    public static Set<String> authorized(Path folder) throws IOException {
        if (!Files.isDirectory(folder)) {
            throw new BridgeException(folder + ": expected a folder with public keys", null);
        }
        Set<String> keys = new TreeSet<>();
        try (Stream<Path> files = Files.list(folder)) {
            for (Path file : files.filter(f -> f.toString().endsWith(PUBLIC_ENDING)).sorted().toList()) {
                keys.add(read(file).publicKey);
            }
        }
        if (keys.isEmpty()) {
            throw new BridgeException(folder + ": expected at least one public key in a file that ends in " + PUBLIC_ENDING, null);
        }
        return keys;
    }

    private static CurveKeys read(Path file) throws IOException {
        if (!Files.isRegularFile(file) || Files.size(file) > LARGEST) {
            throw new BridgeException(file + ": expected a file with a key", null);
        }
        String text = new String(Files.readAllBytes(file), StandardCharsets.ISO_8859_1);
        String publicKey = null;
        String secret = null;
        for (Matcher m = KEY.matcher(text); m.find();) {
            if (!Z85.matcher(m.group(2)).matches()) {
                throw new BridgeException(file + ": " + m.group(1) + "-key: expected 40 characters of Z85", null);
            }
            publicKey = m.group(1).equals("public") ? m.group(2) : publicKey;
            secret = m.group(1).equals("secret") ? m.group(2) : secret;
        }
        if (publicKey == null) {
            throw new BridgeException(file + ": expected a line public-key = \"...\"", null);
        }
        return new CurveKeys(publicKey, secret);
    }

    /** Without the secret, for logs. */
    @Override
    public String toString() {
        return publicKey;
    }
}
