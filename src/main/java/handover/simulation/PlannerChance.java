package handover.simulation;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import java.util.random.RandomGenerator;

/**
 * The planner's chance when one decision may be planned several times: each time with the same numbers, and the next decision
 * goes on after those that the act which was done used. Used by one thread.
 */
final class PlannerChance {
    private final Supplier<RandomGenerator> stream;
    /** The draws of all decisions that were acted on: whether they were of 32 bits. */
    private final List<Boolean> spent = new ArrayList<>();

    /** @param stream gives a generator of the same sequence each time */
    PlannerChance(Supplier<RandomGenerator> stream) {
        this.stream = stream;
    }

    /** Draws of one planning. */
    static final class Draws implements RandomGenerator {
        private final RandomGenerator source;
        private final List<Boolean> drawn = new ArrayList<>();

        private Draws(RandomGenerator source) {
            this.source = source;
        }

        @Override
        public long nextLong() {
            drawn.add(false);
            return source.nextLong();
        }

        @Override
        public int nextInt() {
            drawn.add(true);
            return source.nextInt();
        }
    }

    /** The chance of the next decision; the same each time until one is {@link #spend spent}. */
    Draws next() {
        RandomGenerator source = stream.get();
        for (boolean shortDraw : spent) {
            if (shortDraw) {
                source.nextInt();
            } else {
                source.nextLong();
            }
        }
        return new Draws(source);
    }

    /** The decision that used these draws is acted on. */
    void spend(Draws draws) {
        spent.addAll(draws.drawn);
    }
}
