package handover.bridge;

import java.util.function.Supplier;

/** Where answers and events go. */
interface Outbox {
    void reply(Client client, String json);

    /** Publishes an event; what nobody listens to is not even made. */
    void publish(String topic, Supplier<String> json);
}
