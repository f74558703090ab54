package handover.io;

import handover.domain.AskParameters;
import handover.domain.AskSets;
import handover.domain.DomainSpec;
import handover.domain.GeneratedTable;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Domains of any size by name, {@code generated-N} or {@code generated-N-VARIANT}: a {@link GeneratedTable}, on which the robot may
 * ask about all things that share a word.
 */
final class GeneratedDomains {
    private static final Pattern NAME = Pattern.compile("generated-([0-9]{1,9})(?:-(\\w+))?");

    private GeneratedDomains() {}

    /** The domain of this name, null if it is not such a name. Throws {@link DomainFileException} for too many objects or an unknown variant. */
    static DomainSpec named(String name) {
        Matcher parts = NAME.matcher(name);
        if (!parts.matches()) {
            return null;
        }
        Place place = Place.of(name);
        int n = Integer.parseInt(parts.group(1));
        if (n < 1 || n > GeneratedTable.MOST) {
            throw place.error("expected from 1 to " + GeneratedTable.MOST + " objects");
        }
        String variant = parts.group(2) == null ? DomainSpec.BASE : parts.group(2);
        return Variants.defaults(variant, DomainSpec.of(name, GeneratedTable.objects(n)), place)
                .with(s -> s.ask = new AskParameters(AskSets.ATTRIBUTES));
    }
}
