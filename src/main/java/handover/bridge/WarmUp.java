package handover.bridge;

import handover.domain.HandoverDomain;
import handover.domain.TableObject;
import handover.io.Welcome;
import handover.solver.Policy;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;
import java.util.function.Supplier;

/** A conversation with nobody, so that the first real one does not wait for a program that is still being compiled. */
final class WarmUp {
    private static final long NANOS = 1_500_000_000L;
    private static final int MOST = 500;
    private static final double DECIDE_MS = 25;
    private static final Client NOBODY = new Client(new byte[0]);

    private WarmUp() {}

    /** Talks for about a second. */
    static void run(HandoverDomain domain, Policy policy, Welcome welcome, LongSupplier nanoClock) {
        BlockingQueue<Planner.Plan> plans = new LinkedBlockingQueue<>();
        Outbox outbox = new Outbox() {
            @Override
            public void reply(Client client, String json) {
                json.getBytes(StandardCharsets.UTF_8);
            }

            @Override
            public void publish(String topic, Supplier<String> json) {
                json.get();
            }
        };
        BridgeSettings settings = new BridgeSettings("", "", "", List.of(), Security.LOOPBACK, 0, DECIDE_MS, 0,
                new BridgeSettings.Limits(1, 1, 1));
        try (Service service = new Service(Session.of(domain, 0, 1), policy, welcome, settings, outbox, null, () -> 0, nanoClock,
                plans::add)) {
            long start = nanoClock.getAsLong();
            for (int k = 0; k < MOST && nanoClock.getAsLong() - start < NANOS; k++) {
                talk(service, domain.start().objects().get(k % domain.start().size()), plans);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private static void talk(Service service, TableObject about, BlockingQueue<Planner.Plan> plans) throws InterruptedException {
        say(service, "\"type\":\"begin\"");
        say(service, "\"type\":\"speech\",\"text\":\"" + about.name() + "\"");
        service.stream(bytes("\"type\":\"gesture\",\"hand\":[0,0.5,0.1],\"shoulder\":[0,1,0]"));
        service.work(NANOS);
        say(service, "\"type\":\"decide\"");
        Planner.Plan plan = plans.poll((long) (2 * DECIDE_MS), TimeUnit.MILLISECONDS);
        if (plan != null) {
            service.planned(plan);
        }
        say(service, "\"type\":\"acted\",\"act\":\"WAIT\",\"status\":\"started\"");
        service.tick();
    }

    private static void say(Service service, String fields) {
        service.command(NOBODY, bytes(fields));
    }

    private static byte[] bytes(String fields) {
        return ("{\"v\":1," + fields + "}").getBytes(StandardCharsets.UTF_8);
    }
}
