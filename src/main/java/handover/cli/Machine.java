package handover.cli;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;

/** What measurements were made on. */
final class Machine {
    private static final Path CPU = Path.of("/proc/cpuinfo");

    private Machine() {}

    /** Processor, cores, memory for this Java, load, operating system and Java. */
    static Map<String, Object> describe() {
        Map<String, Object> all = new LinkedHashMap<>();
        all.put("processor", processor());
        all.put("cores", Runtime.getRuntime().availableProcessors());
        all.put("heap_mb", Runtime.getRuntime().maxMemory() >> 20);
        double load = ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage();
        all.put("load_before", load < 0 ? null : load);
        all.put("os", System.getProperty("os.name") + " " + System.getProperty("os.arch"));
        all.put("java", System.getProperty("java.vm.name") + " " + System.getProperty("java.runtime.version"));
        return all;
    }

    private static String processor() {
        try {
            return Files.readAllLines(CPU).stream().filter(line -> line.startsWith("model name"))
                    .map(line -> line.substring(line.indexOf(':') + 1).strip()).findFirst().orElse(unknown());
        } catch (IOException e) {
            return unknown();
        }
    }

    private static String unknown() {
        return "unknown " + System.getProperty("os.arch");
    }
}
