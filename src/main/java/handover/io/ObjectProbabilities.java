package handover.io;

import handover.domain.Scene;
import handover.domain.TableObject;
import handover.math.Simplex;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;

/** A distribution over the objects on the table, as people write it: name to probability, 0 for names left out. */
public final class ObjectProbabilities {
    private static final double ROUNDING = 1e-6;

    private ObjectProbabilities() {}

    /**
     * Reads {@code red_ball=0.7,blue_ball=0.3} or, where there is no equals sign, the JSON file of that name with an object
     * {@code {"red_ball": 0.7, "blue_ball": 0.3}}.
     *
     * @param source what messages call a distribution that is given in place
     * @return one probability per object of the scene, summing to one
     * @throws DomainFileException if a name or number cannot be meant
     */
    public static double[] read(String textOrFile, Scene scene, String source) {
        if (textOrFile.indexOf('=') >= 0) {
            return of(parse(textOrFile, Place.of(source)), scene, Place.of(source));
        }
        if (textOrFile.isBlank() || textOrFile.startsWith("{") || !Files.exists(Path.of(textOrFile))) {
            throw Place.of(source).error("expected NAME=PROBABILITY,NAME=PROBABILITY or a JSON file, got \"" + textOrFile + "\"");
        }
        DomainSource file = DomainSource.ofFile(Path.of(textOrFile));
        Place place = Place.of(file.name());
        try {
            return of(new Fields(JsonText.parse(file.bytes(), file.name()), "").probabilities(), scene, place);
        } catch (FieldException e) {
            throw new DomainFileException(file.name(), e.path(), e.getMessage(), e);
        }
    }

    /**
     * The distribution that a message gives.
     *
     * @param given object to probability
     * @return one probability per object of the scene, summing to one
     * @throws WireException for an object that is not on the table
     */
    public static double[] of(Map<String, Double> given, Scene scene, String path) {
        given.keySet().stream().filter(name -> scene.indexOf(name) < 0).findFirst().ifPresent(name -> {
            throw new WireException(WireCode.UNKNOWN_OBJECT, path + "." + Place.shown(name), "expected one of " + names(scene));
        });
        return vector(given, scene);
    }

    private static Map<String, Double> parse(String text, Place place) {
        Map<String, Double> given = new LinkedHashMap<>();
        for (String part : text.split(",")) {
            String[] pair = part.split("=", 2);
            if (pair.length < 2) {
                throw place.error("expected NAME=PROBABILITY,NAME=PROBABILITY, got \"" + part + "\"");
            }
            Place name = place.key(pair[0].strip());
            if (given.put(pair[0].strip(), number(pair[1].strip(), name)) != null) {
                throw name.error("expected each object once, got it twice");
            }
        }
        return given;
    }

    private static double number(String text, Place place) {
        try {
            return Double.parseDouble(text);
        } catch (NumberFormatException e) {
            throw place.error("expected a probability in [0, 1], got \"" + text + "\"", e);
        }
    }

    private static double[] of(Map<String, Double> given, Scene scene, Place place) {
        double sum = 0;
        for (Map.Entry<String, Double> e : given.entrySet()) {
            if (scene.indexOf(e.getKey()) < 0) {
                throw place.key(e.getKey()).error("expected the name of an object, one of " + names(scene));
            } else if (!(e.getValue() >= 0 && e.getValue() <= 1)) {
                throw place.key(e.getKey()).error("expected a probability in [0, 1], got " + e.getValue());
            }
            sum += e.getValue();
        }
        if (Math.abs(sum - 1) > ROUNDING) {
            throw place.error("expected probabilities that sum to 1, got a sum of " + sum);
        }
        return vector(given, scene);
    }

    private static double[] vector(Map<String, Double> given, Scene scene) {
        double[] p = scene.objects().stream().mapToDouble(o -> given.getOrDefault(o.name(), 0.0)).toArray();
        Simplex.normalise(p, p.length);
        return p;
    }

    private static String names(Scene scene) {
        return String.join(", ", scene.objects().stream().map(TableObject::name).toList());
    }
}
