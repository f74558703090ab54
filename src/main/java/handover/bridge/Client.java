package handover.bridge;

/** Who asked, as the command socket knows them. */
record Client(byte[] identity) {}
