package handover.math;

/**
 * S(b, h): how well what the human believes (h) matches what the robot believes (b); MODEL section 6. All are bounded.
 * Thread safe.
 */
public enum MatchScore {
    /** -||b-h||^2 + ||b||^2 - 1, the expectation of -||e_omega - h||^2 under b; strictly proper, in [-2, 0]. */
    BRIER(false) {
        @Override
        public double of(double[] b, double[] h, int n) {
            double s = -1;
            for (int i = 0; i < n; i++) {
                s += h[i] * (2 * b[i] - h[i]);
            }
            return s;
        }

        /** At h = b. */
        @Override
        public double max(double[] b, int n) {
            return of(b, b, n) + ROUNDING;
        }
    },
    /** sum b log h_eps, h_eps = (1-1e-3) h + 1e-3/N; strictly proper, in [log(1e-3/N), 0]. */
    LOG(false) {
        @Override
        public double of(double[] b, double[] h, int n) {
            double s = 0;
            for (int i = 0; i < n; i++) {
                if (b[i] > 0) {
                    s += b[i] * Math.log(smooth(h[i], n));
                }
            }
            return s;
        }

        /** Minus the entropy of b (Gibbs' inequality), because h_eps is a distribution too. */
        @Override
        public double max(double[] b, int n) {
            double s = ROUNDING;
            for (int i = 0; i < n; i++) {
                s += b[i] > 0 ? b[i] * Math.log(b[i]) : 0;
            }
            return s;
        }
    },
    /** b . h; improper: its best h is a vertex; in [0, 1]. */
    LINEAR(false) {
        @Override
        public double of(double[] b, double[] h, int n) {
            double s = 0;
            for (int i = 0; i < n; i++) {
                s += b[i] * h[i];
            }
            return s;
        }

        /** At the h that is sure of the likeliest. */
        @Override
        public double max(double[] b, int n) {
            return b[Simplex.argmax(b, n)];
        }
    },
    /** -KL(b || h_eps); belief-dependent. */
    KL(true) {
        @Override
        public double of(double[] b, double[] h, int n) {
            double s = 0;
            for (int i = 0; i < n; i++) {
                s -= relativeEntropyTerm(b[i], smooth(h[i], n));
            }
            return s;
        }
    },
    /** -||b-h||_1, in [-2, 0]; belief-dependent. */
    L1(true) {
        @Override
        public double of(double[] b, double[] h, int n) {
            double s = 0;
            for (int i = 0; i < n; i++) {
                s -= Math.abs(b[i] - h[i]);
            }
            return s;
        }
    },
    /** -||b-h||_2^2, in [-2, 0]; belief-dependent. */
    L2(true) {
        @Override
        public double of(double[] b, double[] h, int n) {
            double s = 0;
            for (int i = 0; i < n; i++) {
                double d = b[i] - h[i];
                s -= d * d;
            }
            return s;
        }
    },
    /** -JS(b, h), the Jensen-Shannon divergence in nats, in [-log 2, 0]; belief-dependent. */
    JS(true) {
        @Override
        public double of(double[] b, double[] h, int n) {
            double s = 0;
            for (int i = 0; i < n; i++) {
                double m = (b[i] + h[i]) / 2;
                s -= (relativeEntropyTerm(b[i], m) + relativeEntropyTerm(h[i], m)) / 2;
            }
            return s;
        }
    },
    /** No match reward. */
    NONE(false) {
        @Override
        public double of(double[] b, double[] h, int n) {
            return 0;
        }
    };

    /** Keeps bounds above values that were added up in another order. */
    private static final double ROUNDING = 1e-12;
    /** Weight of the uniform distribution in h_eps, which keeps the logarithmic scores finite. */
    private static final double SMOOTHING = 1e-3;

    private final boolean beliefDependent;

    MatchScore(boolean beliefDependent) {
        this.beliefDependent = beliefDependent;
    }

    /**
     * S(b, h) over the first {@code n} entries; neither array is modified, nothing is allocated.
     *
     * @param b the robot's belief, a distribution over n objects
     * @param h the human's belief, a distribution over n objects
     */
    public abstract double of(double[] b, double[] h, int n);

    /** The largest S(b, h) over all h, or a little more; {@code b} is not modified, nothing is allocated. */
    public double max(double[] b, int n) {
        return 0;
    }

    /** Whether S is not linear in b, so that it is a reward of the belief but not of any state (a rho-POMDP). */
    public boolean beliefDependent() {
        return beliefDependent;
    }

    private static double smooth(double h, int n) {
        return (1 - SMOOTHING) * h + SMOOTHING / n;
    }

    private static double relativeEntropyTerm(double p, double q) {
        return p > 0 ? p * Math.log(p / Math.max(q, Double.MIN_VALUE)) : 0;
    }
}
