package handover.contract;

import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import burlap.mdp.core.action.Action;
import burlap.mdp.core.state.State;
import burlap.mdp.singleagent.environment.EnvironmentOutcome;
import burlap.mdp.singleagent.model.FullModel;
import burlap.mdp.singleagent.model.TransitionProb;
import burlap.mdp.singleagent.pomdp.PODomain;
import burlap.mdp.singleagent.pomdp.observations.ObservationFunction;
import handover.domain.Act;
import handover.domain.ActModel;
import handover.domain.ActType;
import handover.domain.Answer;
import handover.domain.DomainSpec;
import handover.domain.HandoverDomain;
import handover.domain.HandoverState;
import handover.domain.Observation;
import handover.domain.TableObject;
import handover.domain.Task;
import handover.domain.WaitType;
import handover.io.DomainFiles;
import handover.math.MatchScore;
import handover.math.Simplex;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BiFunction;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import java.util.random.RandomGenerator;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

/** The contract can fail: every rule has a variant that breaks it, and the failure names the rule. */
class BrokenVariantsTest {
    private static final DomainSpec SPEC = DomainFiles.read("bowls-and-spoons");

    /** A variant and the rule that it must fail. */
    private record Broken(String what, int rule, Supplier<HandoverDomain> domain) {}

    private static Stream<Broken> broken() {
        return Stream.of(
                new Broken("an act on offer twice", 1, () -> withType(new WaitType(SPEC.act("wait")))),
                new Broken("an act under a verb that no type has", 2, () -> withType(new Odd("NOD", List.of(Act.of("BOW"))))),
                new Broken("an act that tells less than nothing", 3, () -> withType(
                        new Odd("NOD", List.of(Act.of("NOD"), Act.of("NOD", "metal_bowl"))) {
                            @Override
                            public double[] weights(Act act, List<TableObject> present) {
                                return new double[] {1, act.objects().isEmpty() ? -0.5 : 1, 1, 1};
                            }
                        })),
                new Broken("a belief of the human that does not sum to one", 4, () -> new HandoverDomain(SPEC) {
                    @Override
                    public void understand(ActModel act, double[] h, double[] out, int n) {
                        super.understand(act, h, out, n);
                        out[0] *= 0.9;
                    }
                }),
                new Broken("people who say more than they can", 5, () -> new HandoverDomain(SPEC) {
                    @Override
                    public double contentRate(ActType type, double hWanted) {
                        return 1.5;
                    }
                }),
                new Broken("people who say yes and no", 5, () -> new HandoverDomain(SPEC) {
                    @Override
                    public double answerProbability(Answer answer, ActType type, double match) {
                        return 0.8;
                    }
                }),
                new Broken("a lost outcome", 6, () -> withModel((model, random) -> new Wrapped(model) {
                    @Override
                    public List<TransitionProb> transitions(State s, Action a) {
                        List<TransitionProb> all = super.transitions(s, a);
                        return all.size() == 1 ? all : all.subList(1, all.size());
                    }
                })),
                new Broken("a sampler that always takes the first outcome", 7,
                        () -> withModel((model, random) -> new Wrapped(model) {
                            @Override
                            public EnvironmentOutcome sample(State s, Action a) {
                                return transitions(s, a).get(0).eo;
                            }
                        })),
                new Broken("a reward that is no number", 8, () -> new HandoverDomain(SPEC) {
                    @Override
                    public double pickReward(boolean right) {
                        return right ? Double.NaN : super.pickReward(false);
                    }
                }),
                new Broken("a match reward above its bound", 8, () -> new HandoverDomain(SPEC) {
                    @Override
                    public double matchReward(double[] b, double[] h, int n) {
                        return 3 * MatchScore.LINEAR.of(b, h, n);
                    }
                }),
                new Broken("a belief of the human that gives away what is wanted", 9,
                        () -> withModel((model, random) -> new Wrapped(model) {
                            @Override
                            public List<TransitionProb> transitions(State s, Action a) {
                                return super.transitions(s, a).stream().map(t -> leak(t)).toList();
                            }
                        })),
                new Broken("pay after the end", 10, () -> withModel((model, random) -> new Wrapped(model) {
                    @Override
                    public EnvironmentOutcome sample(State s, Action a) {
                        EnvironmentOutcome o = super.sample(s, a);
                        return model.terminal(s) ? new EnvironmentOutcome(s, a, s, 1, true) : o;
                    }
                })),
                new Broken("people who are silent although they should speak", 11,
                        () -> withSenses(senses -> new Sensing(senses) {
                            @Override
                            public State sample(State s, Action a) {
                                Observation o = (Observation) super.sample(s, a);
                                return Walk.base(s).task().answer() == Answer.NONE
                                        ? new Observation(null, o.gesture(), o.signal()) : o;
                            }
                        })),
                new Broken("gestures that are called impossible", 12, () -> withSenses(senses -> new Sensing(senses) {
                    @Override
                    public double probability(State o, State s, Action a) {
                        return ((Observation) o).gesture() != null ? 0 : super.probability(o, s, a);
                    }
                })),
                new Broken("a next state that is another one each time", 13, () -> {
                    AtomicInteger count = new AtomicInteger();
                    return new HandoverDomain(SPEC) {
                        @Override
                        public void understand(ActModel act, double[] h, double[] out, int n) {
                            super.understand(act, h, out, n);
                            double shift = 1e-10 * (1 + count.getAndIncrement() % 7);
                            out[0] += shift;
                            out[1] -= shift;
                        }
                    };
                }),
                new Broken("a variant that its file does not name", 14, () -> new HandoverDomain(SPEC) {}),
                new Broken("a model that is not the one that is filtered", 15, () -> new HandoverDomain(SPEC) {
                    @Override
                    public PODomain generateDomain(RandomGenerator random) {
                        PODomain other = new HandoverDomain(SPEC.with(s -> s.tau = 0.5)).generateDomain(random);
                        PODomain domain = super.generateDomain(random);
                        domain.setModel(new Wrapped((FullModel) other.getModel()));
                        return domain;
                    }
                }),
                new Broken("a reward of the belief that passes for one of the state", 16, () -> new HandoverDomain(SPEC) {
                    @Override
                    public double matchReward(double[] b, double[] h, int n) {
                        return MatchScore.L1.of(b, h, n);
                    }
                }),
                new Broken("a price that the bounds cannot know", 18, () -> new HandoverDomain(SPEC) {
                    @Override
                    public double actReward(Task before, ActModel act) {
                        return super.actReward(before, act) + (act.isPick() && before.reference() != null ? 300 : 0);
                    }
                }),
                new Broken("a domain that BURLAP's agent cannot use", 17, () -> new HandoverDomain(SPEC) {
                    @Override
                    public PODomain generateDomain(RandomGenerator random) {
                        PODomain domain = super.generateDomain(random);
                        domain.setStateEnumerator(null);
                        return domain;
                    }
                }));
    }

    @TestFactory
    Stream<DynamicTest> failsWithTheRightRule() {
        return broken().map(b -> DynamicTest.dynamicTest(b.what(), () -> {
            Rule rule = Rules.ALL.get(b.rule() - 1);
            AssertionError e = assertThrows(AssertionError.class, () -> rule.check(b.domain().get()));
            assertTrue(e.getMessage().startsWith("rule " + b.rule() + " ("), e.getMessage());
        }));
    }

    @TestFactory
    Stream<DynamicTest> everyRuleHasABrokenVariant() {
        return Rules.ALL.stream().map(rule -> DynamicTest.dynamicTest(rule.toString(), () ->
                assertTrue(broken().anyMatch(b -> b.rule() == rule.number()))));
    }

    private static HandoverDomain withType(ActType more) {
        return new HandoverDomain(SPEC) {
            @Override
            protected List<ActType> actTypes() {
                List<ActType> all = new ArrayList<>(super.actTypes());
                all.add(more);
                return all;
            }
        };
    }

    private static HandoverDomain withModel(BiFunction<FullModel, RandomGenerator, FullModel> wrap) {
        return new HandoverDomain(SPEC) {
            @Override
            public PODomain generateDomain(RandomGenerator random) {
                PODomain domain = super.generateDomain(random);
                domain.setModel(wrap.apply((FullModel) domain.getModel(), random));
                return domain;
            }
        };
    }

    private static HandoverDomain withSenses(UnaryOperator<ObservationFunction> wrap) {
        return new HandoverDomain(SPEC) {
            @Override
            public PODomain generateDomain(RandomGenerator random) {
                PODomain domain = super.generateDomain(random);
                domain.setObservationFunction(wrap.apply(domain.getObservationFunction()));
                return domain;
            }
        };
    }

    /** The human expects a little more of what they want than they can know. */
    private static TransitionProb leak(TransitionProb t) {
        HandoverState s = (HandoverState) t.eo.op;
        if (s.wanted() < 0) {
            return t;
        }
        double[] h = s.human().clone();
        h[s.wanted()] += 0.1;
        Simplex.normalise(h, h.length);
        HandoverState told = new HandoverState(s.wanted(), s.task(), h);
        return new TransitionProb(t.p, new EnvironmentOutcome(t.eo.o, t.eo.a, told, t.eo.r, t.eo.terminated));
    }

    private static class Odd extends ActType {
        private final List<Act> acts;

        Odd(String verb, List<Act> acts) {
            super(verb, SPEC.act("look"));
            this.acts = acts;
        }

        @Override
        public List<Act> acts(List<TableObject> present) {
            return acts;
        }
    }

    private static class Wrapped implements FullModel {
        private final FullModel model;

        Wrapped(FullModel model) {
            this.model = model;
        }

        @Override
        public List<TransitionProb> transitions(State s, Action a) {
            return model.transitions(s, a);
        }

        @Override
        public EnvironmentOutcome sample(State s, Action a) {
            return model.sample(s, a);
        }

        @Override
        public boolean terminal(State s) {
            return model.terminal(s);
        }
    }

    private static class Sensing implements ObservationFunction {
        private final ObservationFunction senses;

        Sensing(ObservationFunction senses) {
            this.senses = senses;
        }

        @Override
        public double probability(State o, State s, Action a) {
            return senses.probability(o, s, a);
        }

        @Override
        public State sample(State s, Action a) {
            return senses.sample(s, a);
        }
    }
}
