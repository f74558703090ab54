package handover.domain;

import handover.math.Vector3;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;

/**
 * Tables with any number of things, to try what grows with it: as in a kitchen, most words fit several things, no two have
 * both colour and kind in common, and all lie in rows within reach. The same number always gives the same table.
 */
public final class GeneratedTable {
    /** At most so many things. */
    public static final int MOST = 200;

    private static final List<String> COLOURS = List.of("red", "blue", "white", "green", "brown", "black", "yellow", "orange", "grey",
            "pink");
    private static final List<String> KINDS = List.of("mug", "bowl", "spoon", "plate", "bottle", "knife", "fork", "jar", "pot", "pan",
            "tray", "box", "tin", "tumbler", "lid", "brush", "sponge", "towel", "whisk", "ladle", "grater", "peeler", "timer", "scale",
            "shaker", "board", "funnel", "jug", "basket", "candle");
    private static final List<String> MATERIALS = List.of("metal", "plastic", "wooden", "ceramic", "glass", "paper");
    private static final List<String> SIZES = List.of("small", "large", "tall", "round", "flat", "long");
    /** Metres: the table's half width, its near edge and its depth; how far a thing may lie from its place, of the space to the next. */
    private static final double HALF_WIDTH = 0.6;
    private static final double NEAR = 0.45;
    private static final double DEPTH = 0.45;
    private static final double JITTER = 0.2;

    private GeneratedTable() {}

    /**
     * The things on a table.
     *
     * @param n how many, from 1 to {@link #MOST}
     * @throws IllegalArgumentException for another number
     */
    public static List<TableObject> objects(int n) {
        if (n < 1 || n > MOST) {
            throw new IllegalArgumentException("expected from 1 to " + MOST + " objects, got " + n);
        }
        Random random = new Random(n);
        List<String[]> looks = looks(n, random);
        int columns = (int) Math.ceil(Math.sqrt(1.5 * n));
        int rows = (n + columns - 1) / columns;
        List<TableObject> all = new ArrayList<>();
        for (int i = 0; i < n; i++) {
            double x = place(i % columns, columns, random);
            double y = place(i / columns, rows, random);
            Map<String, Double> words = new LinkedHashMap<>();
            for (String word : looks.get(i)) {
                words.put(word, 1.0);
            }
            words.put(one(MATERIALS, random), 1.0);
            words.put(one(SIZES, random), 1.0);
            all.add(new TableObject(String.join("_", looks.get(i)),
                    new Vector3(HALF_WIDTH * (2 * x - 1), NEAR + DEPTH * y, 0), words, null));
        }
        return all;
    }

    /** Colours and kinds, drawn from so few that each fits several things. */
    private static List<String[]> looks(int n, Random random) {
        List<String[]> all = new ArrayList<>();
        for (String colour : COLOURS.subList(0, Math.max(3, Math.min(COLOURS.size(), n / 2)))) {
            for (String kind : KINDS.subList(0, Math.max(3, Math.min(KINDS.size(), n / 2)))) {
                all.add(new String[] {colour, kind});
            }
        }
        Collections.shuffle(all, random);
        return all.subList(0, n);
    }

    /** About the middle of the k-th of so many equal parts of [0, 1], in whole thousandths. */
    private static double place(int k, int parts, Random random) {
        double middle = (k + 0.5 + JITTER * (2 * random.nextDouble() - 1)) / parts;
        return Math.round(1000 * middle) / 1000.0;
    }

    private static String one(List<String> words, Random random) {
        return words.get(random.nextInt(words.size()));
    }
}
