package handover.theory;

/**
 * What random dialogues are like: objects side by side within 1.2 rad, the robot points at them with p(point at a | i) as
 * in MODEL 3.1, its acts drawn as that model says for an object that it has chosen; the human may miss an act or take it
 * for another.
 *
 * @param objects n, at least 1
 * @param acts how many the robot does
 * @param stay tau_H, in [0, 1]
 * @param attention P(an act is noticed)
 * @param confusion P(a noticed act is taken for another)
 * @param narrowest least sigma of pointing, rad; sigma is log-uniform between the two
 * @param widest largest sigma of pointing, rad
 * @param concentration beta_0 ~ Dir(concentration / n, ...); infinite: beta_0 is known to be uniform
 */
public record DialogueSettings(int objects, int acts, double stay, double attention, double confusion, double narrowest,
        double widest, double concentration) {
    /** Throws {@link IllegalArgumentException} if a number is out of range. */
    public DialogueSettings {
        if (objects < 1 || acts < 0 || !(narrowest > 0 && narrowest <= widest)
                || !(concentration >= 0)) {
            throw new IllegalArgumentException("expected objects >= 1, acts >= 0, 0 < narrowest <= widest and"
                    + " concentration >= 0, got " + objects + ", " + acts + ", " + narrowest + ", " + widest + ", "
                    + concentration);
        }
        Weights.probability("stay", stay);
        Weights.probability("attention", attention);
        Weights.probability("confusion", confusion);
    }

    /** Ten acts, tau_H = 0.95, 10% missed and 10% of the rest confused, sigma from 0.05 to 0.5 rad, beta_0 known. */
    public static DialogueSettings of(int objects) {
        return new DialogueSettings(objects, 10, 0.95, 0.9, 0.1, 0.05, 0.5, Double.POSITIVE_INFINITY);
    }

    /** The same with acts that are noticed with probability {@code q} and then confused with probability {@code p}. */
    public DialogueSettings withPerception(double q, double p) {
        return new DialogueSettings(objects, acts, stay, q, p, narrowest, widest, concentration);
    }
}
