package handover.simulation;

/**
 * What one episode was worth. Immutable.
 *
 * @param success whether the first pick that completed was of the wanted object
 * @param handedOver whether every handover was accepted before the step limit
 * @param seconds all acts took (MODEL 9)
 * @param steps number of acts
 * @param discountedReturn sum of gamma^t r_t
 * @param questions number of ASK
 * @param logScore mean over the decisions of the log score of b, S_log(e_omega, b), in nats
 * @param brierScore the same of the Brier score, in [-2, 0]
 * @param distance mean over the decisions of the L1 distance between h and b, in [0, 2]
 */
public record Measures(boolean success, boolean handedOver, double seconds, int steps, double discountedReturn,
        int questions, double logScore, double brierScore, double distance) {}
