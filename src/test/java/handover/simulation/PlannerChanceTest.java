package handover.simulation;

import static org.junit.jupiter.api.Assertions.assertEquals;

import handover.math.Streams;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.random.RandomGenerator;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;

/** However often decisions are planned, those that count draw what they would draw from one generator, one after the other. */
class PlannerChanceTest {
    @Property(tries = 200)
    void asOneGenerator(@ForAll Random random, @ForAll long seed) {
        PlannerChance chance = new PlannerChance(() -> Streams.of(seed, "planner", 3));
        RandomGenerator plain = Streams.of(seed, "planner", 3);
        for (int decision = 0; decision < 5; decision++) {
            List<Integer> kinds = random.ints(1 + random.nextInt(4), 0, 8).boxed().toList();
            for (int other = random.nextInt(3); other > 0; other--) {
                draw(chance.next(), random.ints(random.nextInt(6), 0, 8).boxed().toList());
            }
            PlannerChance.Draws draws = chance.next();
            List<Number> drawn = draw(draws, kinds);
            assertEquals(drawn, draw(chance.next(), kinds), "the same again until it is spent");
            chance.spend(draws);
            assertEquals(draw(plain, kinds), drawn);
        }
    }

    private static List<Number> draw(RandomGenerator random, List<Integer> kinds) {
        List<Number> drawn = new ArrayList<>();
        for (int kind : kinds) {
            drawn.add(switch (kind) {
                case 0 -> random.nextLong();
                case 1 -> random.nextInt();
                case 2 -> random.nextInt(7);
                case 3 -> random.nextDouble();
                case 4 -> random.nextBoolean() ? 1 : 0;
                case 5 -> random.nextGaussian();
                case 6 -> random.nextLong(1_000_000_007L);
                default -> random.nextInt(-3, 12);
            });
        }
        return drawn;
    }
}
