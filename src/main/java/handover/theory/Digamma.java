package handover.theory;

/**
 * psi(x) to rounding. Hipparchus' {@code Gamma.digamma} (4.0.3) is off by 3e-9 everywhere, which is more than the log
 * moments are worth. Source: Abramowitz and Stegun 6.3.5 (recurrence) and 6.3.18 (asymptotic series).
 */
final class Digamma {
    /** From here on the series below is exact to 1e-17. */
    private static final double LARGE = 12;

    private Digamma() {}

    /** psi(x) for x > 0. */
    static double of(double x) {
        double shift = 0;
        double y = x;
        while (y < LARGE) {
            shift += 1 / y;
            y += 1;
        }
        double z = 1 / (y * y);
        double series = z * (1.0 / 12 - z * (1.0 / 120 - z * (1.0 / 252 - z * (1.0 / 240 - z * (1.0 / 132
                - z * (691.0 / 32760 - z / 12))))));
        return Math.log(y) - 0.5 / y - series - shift;
    }
}
