package handover.theory;

/** Which Dirichlet stands for a distribution over beta that is none. */
public enum Projection {
    /**
     * The one with the same mean and the same E ||beta||^2, so that the expected Brier score stays exact; exists for every
     * distribution (the limits are a point mass and a mixture of vertices).
     */
    MOMENTS,
    /**
     * The one with the same E[log beta_j], which is the nearest in KL(p || Dirichlet) and keeps the expected log score
     * exact, but not the mean. Where an object is excluded with some probability (an infinite logarithm), MOMENTS takes
     * its place. Minka, "Estimating a Dirichlet distribution", 2000.
     */
    LOG_MOMENTS
}
