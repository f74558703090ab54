package handover.tabular;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** Names as .POMDP files have them: a letter, then letters, digits, '_' and '-'. */
final class Names {
    private Names() {}

    /** The text of each thing as a name, each once. */
    static List<String> of(List<?> things) {
        Set<String> taken = new HashSet<>();
        List<String> names = new ArrayList<>();
        for (Object thing : things) {
            String name = String.valueOf(thing).strip().replaceAll("[^A-Za-z0-9_-]+", "_").replaceAll("(?<=.)_+$", "");
            name = name.matches("[A-Za-z].*") ? name : "x" + name;
            String free = name;
            for (int k = 2; !taken.add(free); k++) {
                free = name + "_" + k;
            }
            names.add(free);
        }
        return names;
    }
}
