package handover.simulation;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.ActModel;
import handover.domain.Observation;
import handover.domain.PickSignal;
import handover.solver.Deadline;
import handover.solver.Decision;
import java.util.ArrayList;
import java.util.List;
import java.util.random.RandomGenerator;

/** One episode of a {@link TimedRunner}. Used once, by one thread. */
final class TimedPlay {
    private final TimedRunner run;
    private final Timing timing;
    private final int index;
    private final Agent agent;
    private final VirtualClock clock = new VirtualClock();
    private final World world;
    private final HandoverBelief start;
    private final TimedFilter filter;
    private final PlannerChance chance;
    private final Tally tally;
    private final List<Step> steps = new ArrayList<>();
    private final List<TimedStep> times = new ArrayList<>();
    private final List<Arrival> unread = new ArrayList<>();
    private RandomGenerator latencies;
    /** The act that runs or ran last, its belief not yet known. */
    private Step last;
    private boolean acting;
    private double ended;
    private boolean over;
    /** What is being thought about, null if nothing. */
    private Plan planning;
    /** What was thought of last since the last act started, null if nothing. */
    private Plan ready;
    private int plannings;

    /** A decision, the belief that it is for, and the chance that it took. */
    private record Plan(HandoverBelief belief, long version, double from, Decision decision, PlannerChance.Draws draws) {}

    TimedPlay(TimedRunner run, int index, Agent agent) {
        this.run = run;
        this.timing = run.timing();
        this.index = index;
        this.agent = agent;
        this.world = run.world(index);
        this.start = HandoverBelief.initial(run.planner());
        this.filter = new TimedFilter(start);
        this.chance = run.chance(index);
        this.tally = new Tally(run.planner());
        this.latencies = run.times("latency", index, 0);
    }

    TimedEpisode play() {
        String wanted = world.wanted();
        clock.at(0, () -> {});
        while (!over) {
            if (!clock.advance()) {
                throw new IllegalStateException("episode " + index + " of " + run.solver().name() + " stands still at "
                        + clock.now() + " s: " + filter.now());
            }
            if (!over) {
                choose();
            }
        }
        finish();
        Measures measures = tally.measures(filter.now(), clock.now());
        return new TimedEpisode(new Episode(index, run.solver().name(), wanted, start, List.copyOf(steps), measures, new long[0]),
                times);
    }

    // ---- deciding ------------------------------------------------------------------------------------------------

    /** All that happens now has happened. */
    private void choose() {
        if (agent == Agent.CONCURRENT) {
            chooseWhileObserving();
        } else if (!acting && ready != null) {
            unread.forEach(filter::sensed);
            unread.clear();
            act(ready);
        } else if (!acting && planning == null) {
            plan();
        }
    }

    private void chooseWhileObserving() {
        if (acting && filter.now().pickPending()) {
            return; // how it ends decides what comes next
        }
        boolean mayPlan = acting || clock.now() <= ended + timing.patience();
        if (planning != null && mayPlan && outOfDate(planning)) {
            plan();
        } else if (!acting && ready != null && !outOfDate(ready)) {
            act(ready);
        } else if (planning == null && !mayPlan && ready != null) {
            act(ready);
        } else if (planning == null && (ready == null || ready.version < filter.version())) {
            plan();
        }
    }

    private boolean outOfDate(Plan plan) {
        return timing.replan().due(plan.belief, filter.settled());
    }

    private void plan() {
        HandoverBelief belief = filter.settled();
        PlannerChance.Draws draws = chance.next();
        Plan plan = new Plan(belief, filter.version(), clock.now(), decide(belief, draws), draws);
        planning = plan;
        plannings++;
        clock.at(clock.now() + timing.latency().seconds(plan.decision, latencies), () -> {
            if (planning == plan) { // nobody started anew
                ready = plan;
                planning = null;
            }
        });
    }

    private Decision decide(HandoverBelief belief, RandomGenerator random) {
        HandoverBelief shown = shown(belief);
        try {
            return run.policy().decide(shown, Deadline.NONE, random);
        } catch (RuntimeException e) {
            throw new IllegalStateException(run.solver().name() + " failed in episode " + index + ", at " + shown + ": " + e, e);
        }
    }

    private HandoverBelief shown(HandoverBelief belief) {
        return run.solver().clairvoyant() ? belief.revealed(world.state().wanted()) : belief;
    }

    // ---- acting --------------------------------------------------------------------------------------------------

    private void act(Plan plan) {
        Act act = plan.decision.act();
        ActModel model = filter.now().scene().model(act);
        if (model == null) {
            throw new IllegalStateException(run.solver().name() + " chose " + act + ", which is not legal with "
                    + filter.now().scene() + " on the table");
        }
        finish();
        boolean stale = plan.version < filter.version();
        boolean differs = stale && !decide(filter.settled(), chance.next()).act().equals(act);
        chance.spend(plan.draws);
        tally.score(shown(filter.settled()), world.state().wanted());
        long version = filter.version();
        filter.started(clock.now(), act);
        double reward = world.step(act, filter.now());
        Observation o = world.react(act, run.planner().vocabulary());
        last = new Step(act, o, reward, null);
        tally.add(act, reward, o.signal());

        double duration = run.planner().seconds(model.type());
        boolean completes = o.signal() == PickSignal.ACCEPTED || o.signal() == PickSignal.REJECTED;
        acting = true;
        clock.at(clock.now() + duration, this::end);
        int step = times.size();
        List<Arrival> arrivals = timing.responses().arrivals(clock.now(), model, duration, completes, o, run.times("response", index, step));
        arrivals.forEach(a -> clock.at(a.arrives(), () -> sense(a)));
        times.add(new TimedStep(clock.now(), clock.now() + duration, plan.from, plan.version, version, differs, plannings, arrivals));
        latencies = run.times("latency", index, step + 1);
        planning = null;
        ready = null;
        plannings = 0;
        clock.at(clock.now(), () -> {}); // what is sensed at once comes before the next planning
    }

    private void end() {
        acting = false;
        ended = clock.now();
        filter.ended(clock.now(), last.observation().signal());
        over = filter.now().task().done() || times.size() == run.stepLimit();
    }

    private void sense(Arrival arrival) {
        if (agent == Agent.SEQUENTIAL && planning != null) {
            unread.add(arrival);
        } else {
            filter.sensed(arrival);
        }
    }

    /** What is believed at the end of the last act's step is known. */
    private void finish() {
        if (last != null) {
            steps.add(new Step(last.act(), last.observation(), last.reward(), filter.settled()));
            last = null;
        }
    }
}
