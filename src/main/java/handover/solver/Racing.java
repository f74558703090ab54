package handover.solver;

import handover.math.Simplex;
import handover.math.Streams;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Races acts against each other: every act that may still be the best gets one more drawn observation at a time, the same
 * luck for all, and those that fall behind are left out. Races go deeper one after the other, each among the acts that the
 * one before left. Where {@link BeliefMdp#simple} is a policy that listens, what it earns after each act is raced too, and if the best
 * of that is more than looking ahead promises, that act is taken. Used by one thread at a time.
 *
 * <p>Sources: Maron and Moore, "Hoeffding races" (1993), with the paired differences and the normal bounds of Moore and Lee,
 * "Efficient algorithms for minimizing cross validation error" (1994), section 4; the draws are those of {@link SparseSampling}.
 *
 * @param <N> node of the problem
 */
final class Racing<N> {
    /** An act is out if it is behind by more than so many standard errors and the slack. */
    private static final double STANDARD_ERRORS = 2.5;
    private static final int BATCH = 8;
    /** Better than looking one act ahead, if time does not do for a batch. */
    private static final int FEWEST = 3;
    /** More acts than this do not race: at a table of a hundred objects time would not do for a single batch. */
    private static final int MOST = 128;
    private static final double GOLDEN = 0.6180339887498949;

    /**
     * One race.
     *
     * @param horizon acts to look ahead, at least 2
     * @param width observations drawn for each act below the root
     * @param draws at most so many for each act at the root
     * @param slack in reward: acts that are behind by no more stay in, because the next race sees further
     */
    record Race(int horizon, int width, int draws, double slack) {
        /** A race of {@link Rollouts}, among all acts. */
        static Race ofRollouts(int draws) {
            return new Race(0, 1, draws, 0);
        }

        boolean rollouts() {
            return horizon == 0;
        }
    }

    private record Tree<N>(SparseSampling<N> sampling, int horizon) implements Draws<N> {
        @Override
        public double draw(N root, int act, double stratum, long seed, Deadline limit) {
            return sampling.draw(root, act, horizon, stratum, seed, limit);
        }

        @Override
        public long nodes() {
            return sampling.nodes();
        }
    }

    private final BeliefMdp<N> mdp;
    private final List<Race> races;
    private final SparseSampling<N> first;
    private final List<Draws<N>> draws;
    /** By act, the draws of the running race. */
    private final double[][] drawn;
    private final double[] sums;
    private final int[] alive;
    private int left;
    private double lower;
    private int depth;
    private boolean finished;

    Racing(BeliefMdp<N> mdp, List<Race> races, int acts) {
        this.mdp = mdp;
        this.races = races;
        first = new SparseSampling<>(mdp, 1, true);
        draws = races.stream().map(r -> r.rollouts() ? new Rollouts<>(mdp)
                : new Tree<>(new SparseSampling<>(mdp, r.width, true), r.horizon)).toList();
        drawn = new double[acts][races.stream().mapToInt(Race::draws).max().orElseThrow()];
        sums = new double[acts];
        alive = new int[acts];
    }

    /** Beliefs visited since construction. */
    long nodes() {
        return draws.stream().mapToLong(Draws::nodes).sum();
    }

    /** What the best act and a simple policy after it earn at the last root. */
    double lower() {
        return lower;
    }

    /** How many acts ahead the last race looked of which anything was used. */
    int depth() {
        return depth;
    }

    /** Whether all races were run or one act was left. */
    boolean finished() {
        return finished;
    }

    /**
     * Values of all acts at the root: each from the deepest race that it took part in.
     *
     * @param q receives the values; modified
     * @return the act that won
     */
    int run(N root, long seed, Deadline deadline, double[] q) {
        first.values(root, 1, seed, Deadline.NONE, q);
        depth = 1;
        finished = false;
        int nearest = Simplex.argmax(q, mdp.acts(root));
        lower = q[nearest];
        enter(root, nearest);
        int best = best(q);
        int played = -1;
        double earned = 0;
        for (int k = 0; k < races.size() && left > 1; k++) {
            boolean rollouts = races.get(k).rollouts();
            if (rollouts && mdp.simple(root) < 0) {
                continue;
            }
            int[] others = Arrays.copyOf(alive, left);
            if (rollouts) {
                enter(root, nearest);
            }
            int done = race(root, k, Streams.mix(seed, k), deadline);
            if (done >= BATCH && rollouts) {
                played = best(sums);
                earned = sums[played] / done - error(played, done);
            } else if (done >= (depth == 1 ? FEWEST : BATCH)) {
                for (int i = 0; i < left; i++) {
                    q[alive[i]] = sums[alive[i]] / done;
                }
                best = overtaken(best, best(q), done);
                depth = races.get(k).horizon;
            }
            boolean cut = done < races.get(k).draws && left > 1;
            if (rollouts) {
                left = others.length;
                System.arraycopy(others, 0, alive, 0, left);
            }
            if (cut) {
                return better(best, played, earned, q);
            }
        }
        finished = true;
        return better(best, played, earned, q);
    }

    /** All acts that may be the best enter a race; if there are too many, the most relevant of them, and the best one act ahead. */
    private void enter(N root, int nearest) {
        int[] acts = IntStream.range(0, mdp.acts(root)).filter(a -> mdp.bound(root, a) >= lower).toArray();
        if (acts.length > MOST) {
            acts = Arrays.stream(acts).boxed().sorted(Comparator.comparingDouble(
                    a -> a == nearest ? Double.NEGATIVE_INFINITY : -mdp.relevance(root, a))).limit(MOST).mapToInt(a -> a).sorted().toArray();
        }
        left = acts.length;
        System.arraycopy(acts, 0, alive, 0, left);
    }

    /** What the rollouts favour, if they earn more for sure than the best act is worth by looking ahead. */
    private static int better(int best, int played, double earned, double[] q) {
        if (played < 0 || earned <= q[best]) {
            return best;
        }
        q[played] = Math.max(q[played], earned);
        return played;
    }

    /** The standard error of an act's mean. */
    private double error(int act, int draws) {
        double mean = sums[act] / draws;
        double squares = 0;
        for (int c = 0; c < draws; c++) {
            squares += (drawn[act][c] - mean) * (drawn[act][c] - mean);
        }
        return Math.sqrt(squares / (draws - 1) / draws);
    }

    /** The winner of the last race, unless that of the race before is in and not clearly behind. */
    private int overtaken(int before, int winner, int draws) {
        boolean in = Arrays.stream(alive, 0, left).anyMatch(a -> a == before);
        return in && behind(winner, before, draws, 1) <= 0 ? before : winner;
    }

    /** @return how many draws all acts got that are left */
    private int race(N root, int k, long seed, Deadline deadline) {
        Race race = races.get(k);
        double shift = Streams.mix(seed, -1) * 0x1.0p-64 + 0.5;
        Arrays.fill(sums, 0);
        for (int c = 0; c < race.draws; c++) {
            double stratum = (shift + c * GOLDEN) % 1;
            long luck = Streams.mix(seed, c);
            for (int i = 0; i < left; i++) {
                double value = deadline.passed() ? Double.NaN
                        : draws.get(k).draw(root, alive[i], stratum, luck, deadline);
                if (Double.isNaN(value)) {
                    return undo(i, c);
                }
                drawn[alive[i]][c] = value;
                sums[alive[i]] += value;
            }
            if ((c + 1) % BATCH == 0) {
                leaveOut(c + 1, race.slack);
                if (left == 1) {
                    return c + 1;
                }
            }
        }
        return race.draws;
    }

    /** Takes back the draw that only the first {@code acts} got. */
    private int undo(int acts, int draw) {
        for (int i = 0; i < acts; i++) {
            sums[alive[i]] -= drawn[alive[i]][draw];
        }
        return draw;
    }

    private int best(double[] q) {
        int best = alive[0];
        for (int i = 1; i < left; i++) {
            best = q[alive[i]] > q[best] ? alive[i] : best;
        }
        return best;
    }

    private void leaveOut(int draws, double slack) {
        int best = best(sums);
        int kept = 0;
        for (int i = 0; i < left; i++) {
            int a = alive[i];
            if (a == best || behind(best, a, draws, STANDARD_ERRORS) <= slack) {
                alive[kept++] = a;
            }
        }
        left = kept;
    }

    /** By how much an act is behind at least: the mean difference less some standard errors. */
    private double behind(int best, int act, int draws, double errors) {
        double mean = (sums[best] - sums[act]) / draws;
        double squares = 0;
        for (int c = 0; c < draws; c++) {
            double d = drawn[best][c] - drawn[act][c] - mean;
            squares += d * d;
        }
        return mean - errors * Math.sqrt(squares / (draws - 1) / draws);
    }
}
