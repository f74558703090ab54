package handover.io;

import handover.solver.Solver;
import handover.solver.SolverProvider;
import handover.solver.Solvers;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** {@code nearest:FILE,k=8,radius=0.1,fallback=SPEC}: the fallback comes last, because it may have commas of its own. */
public final class NearestProvider implements SolverProvider {
    private static final Pattern SPEC = Pattern.compile("nearest:(.+?)((?:,(?:k|radius)=[^,]*)*)(?:,fallback=(.+))?", Pattern.DOTALL);
    private static final String USAGE = "expected nearest:FILE[,k=NEIGHBOURS][,radius=DISTANCE][,fallback=SOLVER], in this order";
    private static final int MOST = 1000;

    /** As a service. */
    public NearestProvider() {}

    @Override
    public String name() {
        return "nearest";
    }

    @Override
    public String description() {
        return "as precomputed in FILE; k=8 neighbours within radius=0.1 vote, else fallback=SOLVER decides (the teacher)";
    }

    @Override
    public Solver make(String spec) {
        Matcher m = SPEC.matcher(spec);
        if (!m.matches()) {
            throw new IllegalArgumentException(USAGE);
        }
        int k = Nearest.NEIGHBOURS;
        double radius = Nearest.RADIUS;
        for (String option : m.group(2).isEmpty() ? new String[0] : m.group(2).substring(1).split(",", -1)) {
            String value = option.substring(option.indexOf('=') + 1);
            if (option.startsWith("k=")) {
                k = count(value);
            } else {
                radius = distance(value);
            }
        }
        return new Nearest(path(m.group(1)), k, radius, m.group(3) == null ? null : Solvers.parse(m.group(3)));
    }

    private static Path path(String file) {
        try {
            return Path.of(file);
        } catch (InvalidPathException e) {
            throw new IllegalArgumentException("expected a file, got \"" + file + "\"", e);
        }
    }

    private static int count(String text) {
        int value = text.matches("[0-9]{1,6}") ? Integer.parseInt(text) : 0;
        if (value < 1 || value > MOST) {
            throw new IllegalArgumentException("k: expected a whole number from 1 to " + MOST + ", got \"" + text + "\"");
        }
        return value;
    }

    private static double distance(String text) {
        double value = text.equals("inf") ? Double.POSITIVE_INFINITY
                : text.matches("[0-9]{1,9}(\\.[0-9]{1,18})?|\\.[0-9]{1,18}") ? Double.parseDouble(text) : -1;
        if (value < 0) {
            throw new IllegalArgumentException("radius: expected a distance of at least 0, or inf, got \"" + text + "\"");
        }
        return value;
    }
}
