package handover.solver;

import handover.domain.Act;
import handover.domain.ActModel;
import handover.domain.AskSets;
import handover.domain.CommunicatedObjectDomain;
import handover.domain.DomainSpec;
import handover.domain.HandoverDomain;
import handover.domain.IncrementalCommunicatedDomain;
import handover.domain.IncrementalPickDomain;
import handover.domain.Scene;
import handover.domain.TableObject;
import handover.domain.WrongPick;
import handover.math.Vector3;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;

/**
 * Finds the real symmetries of a scene: the permutations of objects under which every number that the filter, the rewards and
 * the search look at stays the same. These are lambda and M of every act, p(w|i) and "has word w" for some renaming of the
 * words, and the angles between the objects as seen from the human's shoulder, of which alone gesture densities are made (a
 * rotation or reflection maps gestures to equally likely ones). Positions and words usually make every object distinguishable;
 * then the identity is the only one. That holds for every shipped domain.
 *
 * <p>Only for the shipped variants: a user's seams may treat objects by name. Where objects leave the table and the episode
 * goes on, sets of objects are asked about by words whose choice depends on what is left, so there only the identity is used
 * with {@code ask.sets = "attributes"}. At most {@link #MOST} are found; any subset is sound, it only saves less.
 */
final class Symmetries {
    static final int MOST = 24;
    private static final int MOST_CANDIDATES = 5000;
    private static final double SAME = 1e-9;
    private static final Set<Class<?>> VARIANTS = Set.of(HandoverDomain.class, IncrementalPickDomain.class,
            CommunicatedObjectDomain.class, IncrementalCommunicatedDomain.class);

    private final Scene scene;
    private final int n;
    private final double[][] angle;
    /** By word: p(w|i) for each object, then 1 or 0 for whether it has the word. */
    private final List<double[]> words = new ArrayList<>();
    private final List<Symmetry> found = new ArrayList<>();
    private int candidates;

    private Symmetries(Scene scene) {
        this.scene = scene;
        this.n = scene.size();
        this.angle = angles(scene);
        List<String> vocabulary = scene.domain().vocabulary().words();
        for (int w = 0; w < vocabulary.size(); w++) {
            double[] row = Arrays.copyOf(scene.words(null).probabilities(w), 2 * n);
            for (int i = 0; i < n; i++) {
                row[n + i] = scene.objects().get(i).count(vocabulary.get(w)) > 0 ? 1 : 0;
            }
            words.add(row);
        }
    }

    /** The symmetries of a scene, the identity first. */
    static List<Symmetry> of(Scene scene) {
        Symmetries search = new Symmetries(scene);
        search.found.add(Symmetry.identity(search.n, scene.acts().size()));
        DomainSpec spec = scene.domain().spec();
        boolean shrinks = spec.handovers() > 1 || spec.wrongPick() == WrongPick.REMOVED;
        if (VARIANTS.contains(scene.domain().getClass()) && !(shrinks && spec.ask().sets() == AskSets.ATTRIBUTES)) {
            search.extend(new int[search.n], 0);
        }
        return List.copyOf(search.found);
    }

    private static double[][] angles(Scene scene) {
        Vector3 shoulder = scene.domain().spec().shoulder();
        List<Vector3> arms = scene.objects().stream().map(o -> o.position().minus(shoulder)).toList();
        double[][] all = new double[arms.size()][arms.size()];
        for (int i = 0; i < all.length; i++) {
            for (int j = 0; j < all.length; j++) {
                all[i][j] = i == j ? 0 : arms.get(i).angleTo(arms.get(j));
            }
        }
        return all;
    }

    private void extend(int[] to, int k) {
        if (found.size() >= MOST || candidates > MOST_CANDIDATES) {
            return;
        }
        if (k == n) {
            check(to.clone());
            return;
        }
        for (int x = 0; x < n; x++) {
            to[k] = x;
            if (fits(to, k)) {
                extend(to, k + 1);
            }
        }
    }

    private boolean fits(int[] to, int k) {
        for (int j = 0; j < k; j++) {
            if (to[j] == to[k] || Math.abs(angle[j][k] - angle[to[j]][to[k]]) > SAME) {
                return false;
            }
        }
        return true;
    }

    private void check(int[] to) {
        candidates++;
        boolean identity = true;
        for (int i = 0; i < n; i++) {
            identity &= to[i] == i;
        }
        int[] acts = identity || !wordsFit(to) ? null : acts(to);
        if (acts != null) {
            found.add(new Symmetry(to, acts));
        }
    }

    /** Whether the words can be renamed so that their tables are as before. */
    private boolean wordsFit(int[] to) {
        List<double[]> left = new ArrayList<>(words);
        for (double[] row : words) {
            double[] moved = new double[2 * n];
            for (int i = 0; i < n; i++) {
                moved[to[i]] = row[i];
                moved[n + to[i]] = row[n + i];
            }
            int same = 0;
            while (same < left.size() && !same(left.get(same), moved)) {
                same++;
            }
            if (same == left.size()) {
                return false;
            }
            left.remove(same);
        }
        return true;
    }

    /** What each act becomes; null if some act has no counterpart. */
    private int[] acts(int[] to) {
        int[] map = new int[scene.acts().size()];
        for (ActModel m : scene.acts()) {
            ActModel other = scene.model(image(m.act(), to));
            if (other == null || !same(m.lambda(), other.lambda(), to) || !same(m.match(), other.match(), to)
                    || (m.target() < 0 ? -1 : to[m.target()]) != other.target()) {
                return null;
            }
            map[m.index()] = other.index();
        }
        return map;
    }

    private Act image(Act act, int[] to) {
        TreeSet<Integer> indices = new TreeSet<>();
        act.objects().forEach(o -> indices.add(to[scene.indexOf(o)]));
        return new Act(act.verb(), indices.stream().map(i -> scene.objects().get(i)).map(TableObject::name).toList());
    }

    private static boolean same(double[] a, double[] b, int[] to) {
        if (a == null || b == null) {
            return a == b;
        }
        double[] moved = new double[a.length];
        for (int i = 0; i < a.length; i++) {
            moved[to[i]] = a[i];
        }
        return same(moved, b);
    }

    private static boolean same(double[] a, double[] b) {
        for (int i = 0; i < a.length; i++) {
            if (Math.abs(a[i] - b[i]) > SAME) {
                return false;
            }
        }
        return true;
    }
}
