package handover.io;

import handover.tabular.TabularPomdp;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Standard .POMDP files (A. R. Cassandra's format): all of it is read, and what is written is read back as exactly the same model.
 * Thread safe.
 *
 * <p>Wider than the grammar: the statements may come in any order as long as the sizes come before what they are the sizes of, so
 * {@code start} may stand at the end; and a word of the format may be a name where that is not ambiguous. Such names are not written.
 */
public final class PomdpFiles {
    private PomdpFiles() {}

    /**
     * Reads a model.
     *
     * @throws PomdpFileException with the line and column that cannot be meant
     * @throws UncheckedIOException if the file cannot be read
     */
    public static TabularPomdp read(Path file) {
        try {
            if (Files.isDirectory(file)) {
                throw new FileSystemException(file.toString(), null, "is a directory, not a file");
            }
            return parse(new String(Files.readAllBytes(file), StandardCharsets.UTF_8), file.toString());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /**
     * Reads a model from text.
     *
     * @param source what messages call it
     * @throws PomdpFileException with the line and column that cannot be meant
     */
    public static TabularPomdp parse(String text, String source) {
        return new PomdpParser(text, source).parse();
    }

    /**
     * Writes a model: names if they can be names in a file, else numbers.
     *
     * @param comments lines that come first
     */
    public static void write(TabularPomdp m, List<String> comments, Writer out) throws IOException {
        for (String line : comments) {
            out.write("# " + line.replaceAll("\\R", " ") + "\n");
        }
        List<String> states = names(m.states());
        List<String> acts = names(m.acts());
        List<String> observations = names(m.observations());
        out.write("discount: " + m.discount() + "\nvalues: reward\n");
        out.write("states: " + list(m.states()) + "\nactions: " + list(m.acts()) + "\nobservations: " + list(m.observations()) + "\n");
        out.write("start: " + row(m.start()) + "\n");
        for (int a = 0; a < acts.size(); a++) {
            out.write("\n");
            for (int s = 0; s < states.size(); s++) {
                for (int next = 0; next < states.size(); next++) {
                    if (m.transition(a, s, next) > 0) {
                        out.write("T: " + acts.get(a) + " : " + states.get(s) + " : " + states.get(next) + " " + m.transition(a, s, next)
                                + "\n");
                    }
                }
            }
        }
        out.write("\n");
        for (int s = 0; s < states.size(); s++) {
            senses(m, acts, states, observations, s, out);
        }
        for (int a = 0; a < acts.size(); a++) {
            out.write("\n");
            rewards(m, a, acts, states, observations, out);
        }
    }

    /** Rows of O into a state: that of the first act for all, then those of the acts that differ. */
    private static void senses(TabularPomdp m, List<String> acts, List<String> states, List<String> observations, int s, Writer out)
            throws IOException {
        double[] common = senses(m, 0, s);
        out.write("O: * : " + states.get(s) + "\n" + row(common) + "\n");
        for (int a = 1; a < acts.size(); a++) {
            double[] other = senses(m, a, s);
            if (!Arrays.equals(common, other)) {
                out.write("O: " + acts.get(a) + " : " + states.get(s) + "\n" + row(other) + "\n");
            }
        }
    }

    private static double[] senses(TabularPomdp m, int a, int s) {
        return IntStream.range(0, m.observations().size()).mapToDouble(o -> m.observation(a, s, o)).toArray();
    }

    private static void rewards(TabularPomdp m, int a, List<String> acts, List<String> states, List<String> observations, Writer out)
            throws IOException {
        int nexts = m.rewardDependsOnNext(a) ? states.size() : 1;
        int seen = m.rewardDependsOnObservation(a) ? observations.size() : 1;
        for (int s = 0; s < states.size(); s++) {
            for (int next = 0; next < nexts; next++) {
                for (int o = 0; o < seen; o++) {
                    double r = m.reward(a, s, next, o);
                    if (r != 0) {
                        out.write("R: " + acts.get(a) + " : " + states.get(s) + " : " + (nexts == 1 ? "*" : states.get(next)) + " : "
                                + (seen == 1 ? "*" : observations.get(o)) + " " + r + "\n");
                    }
                }
            }
        }
    }

    private static String row(double[] p) {
        StringBuilder text = new StringBuilder();
        for (double x : p) {
            text.append(text.isEmpty() ? "" : " ").append(x == 0 ? "0" : Double.toString(x));
        }
        return text.toString();
    }

    private static boolean nameable(List<String> names) {
        return names.stream().allMatch(PomdpNames::nameable);
    }

    private static List<String> names(List<String> names) {
        return nameable(names) ? names : IntStream.range(0, names.size()).mapToObj(Integer::toString).toList();
    }

    private static String list(List<String> names) {
        return nameable(names) ? String.join(" ", names) : Integer.toString(names.size());
    }
}
