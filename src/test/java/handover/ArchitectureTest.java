package handover;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static org.junit.jupiter.api.Assertions.assertThrows;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaMethodCall;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.library.dependencies.SlicesRuleDefinition;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

/** Which package may use which, and what is the business of one package only. */
class ArchitectureTest {
    private static final JavaClasses CODE = new ClassFileImporter()
            .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS).importPackages("handover");

    /** What each package may use of the others; every package is listed here. */
    private static final Map<String, List<String>> MAY_USE = Map.ofEntries(
            Map.entry("math", List.of()),
            Map.entry("theory", List.of("math")),
            Map.entry("domain", List.of("math")),
            Map.entry("belief", List.of("domain", "theory", "math")),
            Map.entry("solver", List.of("belief", "domain", "math")),
            Map.entry("tabular", List.of("solver", "domain", "math")),
            Map.entry("simulation", List.of("solver", "belief", "domain", "math")),
            Map.entry("io", List.of("simulation", "tabular", "solver", "belief", "domain", "math")),
            Map.entry("report", List.of("simulation", "domain", "math")),
            Map.entry("bridge", List.of("io", "solver", "belief", "domain", "math")),
            Map.entry("cli", List.of("bridge", "report", "io", "simulation", "tabular", "solver", "belief", "domain", "theory", "math")));

    @TestFactory
    Stream<DynamicTest> packagesUseOnlyWhatIsBelowThem() {
        return MAY_USE.entrySet().stream().map(e -> DynamicTest.dynamicTest(e.getKey(), () -> {
            String[] others = MAY_USE.keySet().stream()
                    .filter(p -> !p.equals(e.getKey()) && !e.getValue().contains(p))
                    .map(p -> "handover." + p + "..").toArray(String[]::new);
            check(noClasses().that().resideInAPackage("handover." + e.getKey() + "..")
                    .should().dependOnClassesThat().resideInAnyPackage(others));
        }));
    }

    @Test
    void everyPackageIsListed() {
        check(classes().should().resideInAnyPackage(
                MAY_USE.keySet().stream().map(p -> "handover." + p + "..").toArray(String[]::new)));
    }

    @Test
    void noCycles() {
        check(SlicesRuleDefinition.slices().matching("handover.(*)..").should().beFreeOfCycles());
    }

    @TestFactory
    Stream<DynamicTest> librariesHaveOneHome() {
        return Map.of("com.fasterxml.jackson..", "io", "org.ejml..", "math,theory", "org.zeromq..", "bridge", "picocli..", "cli", "javax.swing..",
                "report", "java.awt..", "report").entrySet().stream()
                .map(e -> DynamicTest.dynamicTest(e.getKey() + " only in " + e.getValue(), () -> {
                    String[] homes = Stream.of(e.getValue().split(",")).map(p -> "handover." + p + "..")
                            .toArray(String[]::new);
                    check(noClasses().that().resideOutsideOfPackages(homes)
                            .should().dependOnClassesThat().resideInAPackage(e.getKey()));
                }));
    }

    @Test
    void clocksOutputAndExitCodesAreTheRimsBusiness() {
        for (String[] call : new String[][] {{"java.lang.System", "nanoTime"}, {"java.lang.System", "currentTimeMillis"},
                {"java.lang.System", "exit"}, {"java.time.Instant", "now"}, {"java.time.Clock", "systemUTC"}}) {
            check(noClasses().that().resideOutsideOfPackages("handover.cli..", "handover.bridge..")
                    .should().callMethodWhere(target(call[0], call[1])));
        }
        check(noClasses().that().resideOutsideOfPackage("handover.cli..").should()
                .accessField(System.class, "out"));
    }

    @Test
    void chanceIsHandedIn() {
        check(noClasses().should().callMethodWhere(target("java.lang.Math", "random")));
        check(noClasses().should().dependOnClassesThat().haveFullyQualifiedName("java.util.concurrent.ThreadLocalRandom"));
    }

    /** The check itself must be able to fail. */
    @Test
    void aWrongArrowIsFound() {
        assertThrows(AssertionError.class, () -> check(noClasses().that().resideInAPackage("handover.belief..")
                .should().dependOnClassesThat().resideInAPackage("handover.domain..")));
    }

    private static DescribedPredicate<JavaMethodCall> target(
            String owner, String method) {
        return DescribedPredicate.describe(owner + "." + method,
                call -> call.getTargetOwner().getFullName().equals(owner) && call.getName().equals(method));
    }

    private static void check(ArchRule rule) {
        rule.allowEmptyShould(true).check(CODE);
    }
}
