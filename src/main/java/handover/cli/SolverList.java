package handover.cli;

import java.util.List;
import java.util.function.UnaryOperator;
import picocli.CommandLine.Help;
import picocli.CommandLine.Help.Column;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.UsageMessageSpec;

/** The solvers at the end of a command's help, in two columns. */
final class SolverList {
    private static final int INDENT = 2;
    private static final int NAMES = 14;

    private SolverList() {}

    /** @param description of a solver, by its name */
    static void append(CommandSpec spec, List<String> names, UnaryOperator<String> description) {
        spec.usageMessage().sectionMap().put(UsageMessageSpec.SECTION_KEY_FOOTER, help -> text(help, names, description));
    }

    private static String text(Help help, List<String> names, UnaryOperator<String> description) {
        int width = help.commandSpec().usageMessage().width();
        Help.TextTable table = Help.TextTable.forColumns(help.colorScheme(), new Column(NAMES, INDENT, Column.Overflow.SPAN),
                new Column(width - NAMES, 0, Column.Overflow.WRAP));
        table.indentWrappedLines = 0;
        names.forEach(name -> table.addRowValues(name, description.apply(name)));
        return String.format("%nSolvers:%n%s", table);
    }
}
