package handover.domain;

/**
 * People who miss one act in ten and misread another one (MODEL 8): the robot cannot know what they believe that it will do,
 * and holds a belief over that too. Any domain becomes one of these by its {@code perception}; this variant is only a
 * different default, and with both probabilities 0 it is the base domain. Immutable, thread safe.
 *
 * <p>Source: "Progress Report: Social Feedback for Robotic Collaboration", section 4.
 */
public class NestedBeliefDomain extends HandoverDomain {
    /** As {@link HandoverDomain#HandoverDomain}. */
    public NestedBeliefDomain(DomainSpec spec) {
        super(spec);
    }

    /** The defaults of this variant. */
    public static DomainSpec defaults(DomainSpec base) {
        return base.with(s -> s.perception = base.perception().with(0.1, 0.1));
    }
}
