package handover.theory;

/**
 * What moment matching keeps of a distribution over beta. Arrays must not be modified.
 *
 * @param mean m = E[beta], sums to one
 * @param square q = E ||beta||^2
 */
record Moments(double[] mean, double square) {
    /** Sum of m_j^2, the least that q can be. */
    double meanSquared() {
        double s = 0;
        for (double x : mean) {
            s += x * x;
        }
        return s;
    }
}
