package handover.io;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;

/**
 * The joints of an arm under the names that skeleton trackers use: Kinect ({@code ShoulderLeft}), Azure Kinect
 * ({@code K4ABT_JOINT_SHOULDER_LEFT}), ROS4HRI ({@code left_shoulder}, {@code l_shoulder}), MediaPipe ({@code LEFT_SHOULDER}).
 *
 * @param names {@code shoulder_left} to the name that is used for it
 */
record Joints(Map<String, String> names) {
    private static final Set<String> DECORATION = Set.of("k4abt", "joint", "type", "nui", "skeleton", "position");
    private static final Map<String, String> SIDES = Map.of("left", "left", "l", "left", "right", "right", "r", "right");
    private static final String SHOULDER = "shoulder";
    private static final List<String> HANDS = List.of("hand", "wrist");

    /** The joints of a skeleton by its names; others than those of arms are let be. */
    static Joints of(Stream<String> all) {
        Map<String, String> names = new HashMap<>();
        all.forEach(name -> {
            String standard = standard(name);
            if (standard != null) {
                names.putIfAbsent(standard, name);
            }
        });
        return new Joints(names);
    }

    private static String standard(String name) {
        String side = null;
        List<String> part = new ArrayList<>();
        for (String word : name.split("(?<=[a-z])(?=[A-Z])|[^A-Za-z0-9]+")) {
            String lower = word.toLowerCase(Locale.ROOT);
            if (side == null && SIDES.containsKey(lower)) {
                side = SIDES.get(lower);
            } else if (!lower.isEmpty() && !DECORATION.contains(lower)) {
                part.add(lower);
            }
        }
        boolean known = part.size() == 1 && (part.get(0).equals(SHOULDER) || HANDS.contains(part.get(0)));
        return known && side != null ? part.get(0) + "_" + side : null;
    }

    boolean hasArm(String side) {
        return names.containsKey(SHOULDER + "_" + side) && HANDS.stream().anyMatch(h -> names.containsKey(h + "_" + side));
    }

    /** The name of the shoulder; a standard one if there is none. */
    String shoulder(String side) {
        return names.getOrDefault(SHOULDER + "_" + side, SHOULDER + "_" + side);
    }

    /** The name of the hand, else of the wrist; a standard one if there is neither. */
    String hand(String side) {
        return HANDS.stream().map(h -> names.get(h + "_" + side)).filter(n -> n != null).findFirst().orElse("hand_" + side);
    }
}
