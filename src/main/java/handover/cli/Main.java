package handover.cli;

import handover.bridge.BridgeException;
import handover.io.DomainFileException;
import handover.io.EpisodeLogException;
import handover.io.PolicyFileException;
import handover.io.PomdpFileException;
import handover.solver.Solvers;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.util.List;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Help.Ansi;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ScopeType;

/** The command {@code handover}. */
@Command(name = "handover", mixinStandardHelpOptions = true, scope = ScopeType.INHERIT, version = "handover 0.1.0",
        sortOptions = false, usageHelpAutoWidth = true, description = "Makes a robot hand a person the object that they want.",
        footer = {"", "Exit codes: 0 fine; 1 a difference was found or a run failed; 2 bad input or usage.",
            "Without any argument: handover simulate."})
public final class Main implements Runnable {
    static final int FINE = 0;
    static final int DIFFERENT = 1;
    static final int BAD_INPUT = 2;

    @Option(names = "--debug", scope = ScopeType.INHERIT, description = "Show where in the program an error came from.")
    private boolean debug;

    private final Console console;

    private Main(Console console) {
        this.console = console;
    }

    /** Runs a command and ends the process with its exit code. */
    public static void main(String[] args) {
        PrintStream out = new PrintStream(new FileOutputStream(FileDescriptor.out), true, StandardCharsets.UTF_8);
        PrintStream err = new PrintStream(new FileOutputStream(FileDescriptor.err), true, StandardCharsets.UTF_8);
        int code = run(args, new Console(System.in, out, err, Console.errorIsTerminal(), System::nanoTime));
        if (out.checkError()) {
            err.println("handover: the output could not be written");
            code = DIFFERENT;
        }
        if (code != FINE) {
            System.exit(code);
        }
    }

    /**
     * Runs a command in this process.
     *
     * @return its exit code
     */
    public static int run(String[] args, InputStream in, PrintStream out, PrintStream err) {
        return run(args, new Console(in, out, err, false, System::nanoTime));
    }

    static int run(String[] args, Console console) {
        Main main = new Main(console);
        CommandLine line = new CommandLine(main)
                .addSubcommand(new Simulate(console))
                .addSubcommand(new Plan(console))
                .addSubcommand(new Check(console))
                .addSubcommand(new Replay(console))
                .addSubcommand(new Infer(console))
                .addSubcommand(new CommandLine(new BridgeCommand(console)).addSubcommand(new BridgeKeygen(console)))
                .addSubcommand(new Bench(console))
                .addSubcommand(new Precompute(console))
                .addSubcommand(new Solve(console))
                .addSubcommand(new Export(console))
                .addSubcommand(new CommandLine(new Analyze()).addSubcommand(new AnalyzeReward(console))
                        .addSubcommand(new AnalyzeCancels(console)).addSubcommand(new AnalyzeNearest(console))
                        .addSubcommand(new AnalyzeNested(console)).addSubcommand(new AnalyzeLoss(console)));
        line.setOut(new PrintWriter(console.out(), true)).setErr(new PrintWriter(console.err(), true));
        line.setExpandAtFiles(false);
        line.setColorScheme(CommandLine.Help.defaultColorScheme(console.live() ? Ansi.AUTO : Ansi.OFF));
        line.setParameterExceptionHandler((e, given) -> main.refuse(e));
        line.setExecutionExceptionHandler((e, command, result) -> main.fail(e));
        try {
            return line.execute(args.length == 0 ? new String[] {"simulate"} : args);
        } catch (OutOfMemoryError e) {
            return main.complain(e, DIFFERENT, "there is not enough memory for this; make it smaller or give Java more (JAVA_OPTS=-Xmx8g)");
        }
    }

    /** Only called if there is a command line, but no command in it. */
    @Override
    public void run() {
        throw new UsageException("expected a command: simulate, plan, check, replay, infer, bridge, bench, precompute, solve, export, analyze; see handover --help");
    }

    private int refuse(CommandLine.ParameterException e) {
        String help = e.getCommandLine().getCommandSpec().qualifiedName() + " --help";
        List<String> meant = e instanceof CommandLine.UnmatchedArgumentException u ? u.getSuggestions() : List.of();
        return complain(e, BAD_INPUT, problem(e) + (meant.isEmpty() ? "" : "; did you mean "
                + String.join(" or ", meant) + "?") + " (see " + help + ")");
    }

    /** What picocli says, but of numbers without naming Java's types. */
    private static String problem(CommandLine.ParameterException e) {
        ArgSpec arg = e.getArgSpec();
        if (arg == null || !(e.getCause() instanceof CommandLine.TypeConversionException)) {
            return e.getMessage();
        }
        String got = e.getValue();
        boolean digits = got.matches("[+-]?[0-9]+");
        String expected = switch (arg.auxiliaryTypes()[0].getSimpleName()) {
            case "int", "Integer" -> "a whole number" + (digits ? " from " + Integer.MIN_VALUE + " to " + Integer.MAX_VALUE : "");
            case "long", "Long" -> "a whole number" + (digits ? " from " + Long.MIN_VALUE + " to " + Long.MAX_VALUE : "");
            case "double", "Double" -> "a number";
            default -> null;
        };
        String name = arg instanceof OptionSpec option ? option.longestName() : arg.paramLabel();
        return expected == null ? e.getMessage() : name + ": expected " + expected + ", got " + (digits ? got : "\"" + got + "\"");
    }

    private int fail(Exception e) {
        Throwable cause = e instanceof UncheckedIOException ? e.getCause() : e;
        boolean input = cause instanceof UsageException || cause instanceof BridgeException || cause instanceof DomainFileException
                || cause instanceof EpisodeLogException || cause instanceof PolicyFileException || cause instanceof PomdpFileException || cause instanceof Solvers.BadSolverException;
        if (input) {
            return complain(e, BAD_INPUT, cause.getMessage());
        } else if (cause instanceof FileSystemException f) {
            return complain(e, BAD_INPUT, f.getFile() + ": " + (f.getReason() == null ? explain(f) : f.getReason()));
        } else if (cause instanceof IOException || cause instanceof IllegalStateException) {
            return complain(e, DIFFERENT, cause.getMessage());
        }
        return complain(e, DIFFERENT, "this should not have happened, please report it with the output of --debug: " + cause);
    }

    private static String explain(FileSystemException e) {
        return switch (e.getClass().getSimpleName()) {
            case "AccessDeniedException" -> "permission denied";
            case "NoSuchFileException" -> "there is no such file or folder";
            default -> e.getClass().getSimpleName();
        };
    }

    private int complain(Throwable e, int code, String problem) {
        console.err().println("handover: " + String.valueOf(problem).replaceAll("\\s*\\R\\s*", " "));
        if (debug) {
            e.printStackTrace(console.err());
        }
        return code;
    }
}
