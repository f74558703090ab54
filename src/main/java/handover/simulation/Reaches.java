package handover.simulation;

import handover.domain.Act;
import handover.domain.Answer;
import handover.domain.PickSignal;
import handover.domain.PickType;
import java.util.ArrayList;
import java.util.List;

/**
 * How the robot's reaches went in an episode with one wish: which it called off, and how soon after the human objected.
 * Immutable.
 *
 * @param wrong whether the first pick that completed was of an object that was not wanted
 * @param correctCancels reaches for something else that were called off
 * @param falseCancels reaches for the wanted object that were called off
 * @param objections reaches for something else during which the human said no
 * @param heeded the objections after which the robot did something else
 */
public record Reaches(boolean wrong, int correctCancels, int falseCancels, int objections, List<Heeded> heeded) {

    /**
     * A reach that was called off after the human said no.
     *
     * @param objected number of the step to which they said no
     * @param cancelled number of the step in which the robot did something else
     */
    public record Heeded(int objected, int cancelled) {}

    /** For each objection that was heeded: how many acts later the robot did something else, 1 for at once. */
    public List<Integer> stepsToCancel() {
        return heeded.stream().map(h -> h.cancelled - h.objected).toList();
    }

    /** Reads an episode with one handover, in which the wish stands still. */
    public static Reaches of(Episode episode) {
        int correct = 0;
        int mistaken = 0;
        int objections = 0;
        List<Heeded> heeded = new ArrayList<>();
        int objected = -1;
        List<Step> steps = episode.steps();
        for (int k = 0; k < steps.size(); k++) {
            Act act = steps.get(k).act();
            boolean reaching = k > 0 && steps.get(k - 1).act().verb().equals(PickType.VERB) && !completes(steps.get(k - 1));
            if (reaching && !act.equals(steps.get(k - 1).act())) {
                boolean right = isOf(steps.get(k - 1).act(), episode.wanted());
                correct += right ? 0 : 1;
                mistaken += right ? 1 : 0;
                if (objected >= 0) {
                    heeded.add(new Heeded(objected, k));
                }
                objected = -1;
            }
            boolean wrongReach = act.verb().equals(PickType.VERB) && !isOf(act, episode.wanted());
            if (!wrongReach || completes(steps.get(k))) {
                objected = -1;
            } else if (objected < 0 && saysNo(steps.get(k))) {
                objected = k;
                objections++;
            }
        }
        return new Reaches(wrong(steps), correct, mistaken, objections, List.copyOf(heeded));
    }

    private static boolean wrong(List<Step> steps) {
        return steps.stream().filter(Reaches::completes).findFirst()
                .map(s -> s.observation().signal() == PickSignal.REJECTED).orElse(false);
    }

    private static boolean completes(Step step) {
        PickSignal signal = step.observation().signal();
        return signal == PickSignal.ACCEPTED || signal == PickSignal.REJECTED;
    }

    private static boolean isOf(Act act, String object) {
        return act.objects().equals(List.of(object));
    }

    private static boolean saysNo(Step step) {
        return step.observation().speech() != null && step.observation().speech().answer() == Answer.NO;
    }
}
