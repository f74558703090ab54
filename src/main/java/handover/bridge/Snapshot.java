package handover.bridge;

import handover.belief.HandoverBelief;
import handover.domain.Answer;
import handover.domain.Task;

/**
 * What is believed at one moment of a session. Immutable, thread safe.
 *
 * @param version counts the messages that were applied
 * @param episode counts the episodes, from 1; 0 before the first
 * @param seed of the chance that the episode's decisions use
 * @param belief of an episode that has ended, what was believed last
 * @param running whether the episode is under way
 * @param acts that the robot completed in this episode
 */
public record Snapshot(long version, long episode, long seed, HandoverBelief belief, boolean running, int acts) {

    /** Whether the task is done, so that there is nothing to decide. */
    boolean over() {
        return belief.task().done();
    }

    /**
     * Whether what is planned for this can still be meant: in the same episode the robot has done nothing since, and the table
     * has the same objects, wherever they are.
     */
    boolean stillMeant(Snapshot now) {
        Task then = belief.task();
        Task task = now.belief.task();
        return this == now || episode == now.episode && Table.sameObjects(then.scene(), task.scene())
                && then.on(task.scene()).answered(Answer.NONE).equals(task.answered(Answer.NONE));
    }

    /** The next version. */
    Snapshot with(HandoverBelief next) {
        return new Snapshot(version + 1, episode, seed, next, running, acts);
    }

    /** The same version with one more act. */
    Snapshot afterAct() {
        return new Snapshot(version, episode, seed, belief, running, acts + 1);
    }

    /** The next version, in which an episode begins; {@code own} is its seed, null for the same as before. */
    Snapshot begun(HandoverBelief start, Long own) {
        return new Snapshot(version + 1, episode + 1, own == null ? seed : own, start, true, 0);
    }

    /** The next version, in which the episode ends. */
    Snapshot ended() {
        return new Snapshot(version + 1, episode, seed, belief, false, acts);
    }
}
