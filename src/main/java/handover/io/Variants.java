package handover.io;

import handover.domain.CommunicatedObjectDomain;
import handover.domain.DomainSpec;
import handover.domain.HandoverDomain;
import handover.domain.IncrementalCommunicatedDomain;
import handover.domain.IncrementalPickDomain;
import handover.domain.InvalidParameterException;
import handover.domain.NestedBeliefDomain;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Modifier;
import java.util.Map;
import java.util.TreeMap;

/**
 * The domain class that a domain file names under {@code variant}: one that is shipped, or any class on the class path that
 * extends {@link HandoverDomain} and has a public constructor from a {@link DomainSpec}. Its defaults are those of its
 * public static method {@code defaults(DomainSpec)}, own or inherited.
 */
final class Variants {
    private static final Map<String, Class<? extends HandoverDomain>> SHIPPED = new TreeMap<>(Map.of(
            DomainSpec.BASE, HandoverDomain.class,
            "incremental", IncrementalPickDomain.class,
            "communicated", CommunicatedObjectDomain.class,
            "incremental_communicated", IncrementalCommunicatedDomain.class,
            "nested", NestedBeliefDomain.class));

    private Variants() {}

    /** What a file of this variant need not say; throws {@link DomainFileException} for an unknown variant. */
    static DomainSpec defaults(String variant, DomainSpec base, Place at) {
        Class<? extends HandoverDomain> type = find(variant, at);
        try {
            return ((DomainSpec) type.getMethod("defaults", DomainSpec.class).invoke(null, base))
                    .with(s -> s.variant = variant);
        } catch (NoSuchMethodException e) {
            return base.with(s -> s.variant = variant);
        } catch (ReflectiveOperationException | ClassCastException | NullPointerException e) {
            throw at.error("expected a public static method DomainSpec defaults(DomainSpec) in " + type.getName()
                    + ", but it failed: " + cause(e), e);
        }
    }

    /** The domain itself; throws {@link DomainFileException} if it cannot be made. */
    static HandoverDomain create(DomainSpec spec, Place at) {
        Class<? extends HandoverDomain> type = find(spec.variant(), at);
        try {
            HandoverDomain domain = type.getConstructor(DomainSpec.class).newInstance(spec);
            domain.start().acts();
            return domain;
        } catch (InvalidParameterException e) {
            throw at.invalid(e);
        } catch (InvocationTargetException e) {
            if (e.getCause() instanceof InvalidParameterException invalid) {
                throw at.invalid(invalid);
            }
            throw at.error("the constructor of " + type.getName() + " failed: " + cause(e), e);
        } catch (ReflectiveOperationException e) {
            throw at.error("expected a public constructor " + type.getSimpleName() + "(DomainSpec) in "
                    + type.getName(), e);
        }
    }

    private static Class<? extends HandoverDomain> find(String variant, Place at) {
        if (SHIPPED.containsKey(variant)) {
            return SHIPPED.get(variant);
        }
        try {
            Class<?> type = Class.forName(variant, true, Thread.currentThread().getContextClassLoader());
            if (HandoverDomain.class.isAssignableFrom(type) && !Modifier.isAbstract(type.getModifiers())) {
                return type.asSubclass(HandoverDomain.class);
            }
        } catch (ClassNotFoundException | LinkageError e) {
            throw at.key("variant").error(expected(variant) + "; no such class is on the class path", e);
        }
        throw at.key("variant").error(expected(variant) + "; that class does not extend HandoverDomain");
    }

    private static String expected(String variant) {
        return "expected " + String.join(", ", SHIPPED.keySet()) + " or the name of a class, got \"" + variant + "\"";
    }

    private static String cause(Throwable e) {
        return String.valueOf(e.getCause() == null ? e : e.getCause());
    }
}
