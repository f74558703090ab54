package handover.bridge;

import handover.io.WireException;
import handover.io.WireMessage;

/** What a client who asked for a decision can be told. */
interface Answers {
    /** @param json on one line */
    void reply(Client client, String json);

    /** @param json on one line */
    void decision(Client client, String json);

    void refuse(Client client, WireMessage.Envelope envelope, WireException why);
}
