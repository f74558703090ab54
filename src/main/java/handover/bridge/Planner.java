package handover.bridge;

import handover.math.Streams;
import handover.solver.Deadline;
import handover.solver.Decision;
import handover.solver.Policy;
import handover.solver.Replan;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.SynchronousQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import java.util.function.Supplier;

/**
 * Plans in the background, from the newest belief, and again when the belief moved on meanwhile. Normally one thread plans;
 * further ones are only for decisions that are asked for while a solver that ignores its deadline is still at an old one.
 * Thread safe.
 */
final class Planner implements AutoCloseable {
    /** So many solvers may be stuck at once. */
    private static final int THREADS = 4;
    private static final long IDLE_SECONDS = 60;
    /** Thinking ends so long before the deadline, or at nine tenths of it, so that what was thought can be said in time. */
    private static final long MARGIN_NANOS = 5_000_000;
    /** A decision is planned at most so often; a run that was broken off had at least one part in so many of the limit. */
    private static final int ATTEMPTS = 20;
    /** Planning again is worth while with a tenth of the limit left, or with so much. */
    private static final long USEFUL_NANOS = 200_000_000;

    private final Policy policy;
    private final Replan replan;
    private final Supplier<Snapshot> newest;
    private final LongSupplier nanoClock;
    private final Consumer<Plan> done;
    private final AtomicLong threads = new AtomicLong();
    private final ThreadPoolExecutor pool;

    /**
     * @param newest the belief now, from any thread
     * @param nanoClock as {@link System#nanoTime}
     * @param done receives each plan, on the thread that made it
     */
    Planner(Policy policy, Replan replan, Supplier<Snapshot> newest, LongSupplier nanoClock, Consumer<Plan> done) {
        this.policy = policy;
        this.replan = replan;
        this.newest = newest;
        this.nanoClock = nanoClock;
        this.done = done;
        this.pool = new ThreadPoolExecutor(0, THREADS, IDLE_SECONDS, TimeUnit.SECONDS, new SynchronousQueue<>(), task -> {
            Thread thread = new Thread(task, "handover-planner-" + threads.incrementAndGet());
            thread.setDaemon(true);
            return thread;
        });
    }

    /** What is to be decided by when. */
    final class Job implements Runnable {
        private final long number;
        private final long asked;
        private final long limit;
        private volatile boolean cancelled;
        private volatile Plan latest;

        private Job(long number, long asked, long limit) {
            this.number = number;
            this.asked = asked;
            this.limit = limit;
        }

        /** Nobody waits for it any more. */
        void cancel() {
            cancelled = true;
        }

        /** Nanoseconds since the decision was asked for. */
        long elapsed() {
            return nanoClock.getAsLong() - asked;
        }

        /** Nanoseconds to its deadline, negative when that has passed. */
        long left() {
            return limit - elapsed();
        }

        /** Whether there is no time to think any more. */
        boolean over() {
            return cancelled || left() <= Math.min(MARGIN_NANOS, limit / 10);
        }

        /** The plan for the newest belief for which one was made so far, null if there is none. */
        Plan latest() {
            return latest;
        }

        private boolean worthAnother() {
            return left() > Math.min(USEFUL_NANOS, limit / 10);
        }

        @Override
        public void run() {
            Snapshot at = newest.get();
            try {
                boolean again = !at.over();
                for (int k = 1; again; k++) {
                    Attempt attempt = new Attempt(this, at);
                    latest = new Plan(this, at, policy.decide(at.belief(), attempt, Streams.of(at.seed(), "planner", number)), null);
                    again = k < ATTEMPTS && !over() && attempt.outOfDate();
                    at = newest.get();
                    again = again && !at.over();
                }
                done.accept(latest == null ? new Plan(this, at, null, null) : latest);
            } catch (RuntimeException | LinkageError | StackOverflowError | OutOfMemoryError e) {
                done.accept(new Plan(this, at, null, e));
            }
        }
    }

    /**
     * One run of the policy: over at the deadline, or when its belief is out of date. That is so at once if it is about what is
     * not the case any more, such as another episode or table; and if the belief moved too far, as long as a useful share of
     * the limit is left. Only a run that had its share of the limit is broken off because of that, so that a belief that never
     * rests still gets a plan.
     */
    private final class Attempt implements Deadline {
        private final Job job;
        private final Snapshot at;
        private final long start = nanoClock.getAsLong();
        private Snapshot compared;
        private boolean moved;
        private boolean pointless;
        private boolean over;

        Attempt(Job job, Snapshot at) {
            this.job = job;
            this.at = at;
            this.compared = at;
        }

        @Override
        public synchronized boolean passed() {
            over = over || job.over() || outOfDate() && (pointless || hadItsShare());
            return over;
        }

        private boolean hadItsShare() {
            return nanoClock.getAsLong() - start >= job.limit / ATTEMPTS;
        }

        /** Whether to plan again, if there is any time. */
        synchronized boolean outOfDate() {
            Snapshot now = newest.get();
            if (now != compared) {
                compared = now;
                pointless = !at.stillMeant(now);
                moved = replan.due(at.belief(), now.belief());
            }
            return pointless || moved && job.worthAnother();
        }
    }

    /**
     * What came of a job.
     *
     * @param at what it was planned for
     * @param decision null if it failed, or if the task was done already, so that nothing was planned
     * @param failure why it failed, else null
     */
    record Plan(Job job, Snapshot at, Decision decision, Throwable failure) {}

    /**
     * A decision that is asked for now.
     *
     * @param number of the decision, which names its chance
     * @param nanos until it is wanted
     */
    Job job(long number, long nanos) {
        return new Job(number, nanoClock.getAsLong(), nanos);
    }

    /** Starts to plan; false if too many solvers are stuck. */
    boolean start(Job job) {
        try {
            pool.execute(job);
            return true;
        } catch (RejectedExecutionException e) {
            return false;
        }
    }

    @Override
    public void close() {
        pool.shutdownNow();
    }
}
