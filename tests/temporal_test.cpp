// Temporal functions against values worked out by hand.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <new>
#include <numbers>
#include <thread>

#include "scene/error.h"
#include "scene/temporal_evaluator.h"

namespace {
thread_local long allocations = 0;
}

// Not inlined: the compiler would take malloc and delete for a mismatched pair.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size ? size : 1)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace restframe {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const TemporalValue yellow(1, 1, 0), blue(0, 0, 1), own(0.25F);
constexpr double inf = std::numeric_limits<double>::infinity();

// The value of the only function; `own` is the property's own.
TemporalValue at(const TemporalFunction& function, double time) {
  TemporalEvaluator evaluator({function});
  return evaluator.value(0, time, own);
}

// The paper's blue ball that flashes yellow for half of each second.
IntervalFunction blink() {
  return {1.0, {{0, 0.5, yellow}, {0.5, 1, blue}}};
}

TEST(Intervals, AreHalfOpen) {
  EXPECT_EQ(at(blink(), 0), yellow);
  EXPECT_EQ(at(blink(), std::nextafter(0.5, 0.0)), yellow);
  EXPECT_EQ(at(blink(), 0.5), blue);
  EXPECT_EQ(at(blink(), std::nextafter(1.0, 0.0)), blue);
  EXPECT_EQ(at(blink(), 1), yellow);
}

TEST(Intervals, WrapDownwardAtNegativeTimes) {
  EXPECT_EQ(at(blink(), -0.25), blue);
  EXPECT_EQ(at(blink(), -0.5), blue);
  EXPECT_EQ(at(blink(), -0.75), yellow);
  EXPECT_EQ(at(blink(), -1), yellow);
  EXPECT_EQ(at(blink(), -1e-300), blue);
  EXPECT_EQ(at(blink(), -1e6 - 0.25), blue);
}

TEST(Intervals, KeepTheirPhaseFarFromZero) {
  EXPECT_EQ(at(blink(), 1e9 + 0.25), yellow);
  EXPECT_EQ(at(blink(), 1e9 + 0.75), blue);
  IntervalFunction tenths{0.1, {{0, 0.05, yellow}, {0.05, 0.1, blue}}};
  for (int i = -1000; i < 1000; ++i) {
    EXPECT_EQ(at(tenths, 0.1 * i + 0.025), yellow) << i;
    EXPECT_EQ(at(tenths, 0.1 * i + 0.075), blue) << i;
  }
}

TEST(Intervals, AreCoveredWithoutAGapAtEveryTime) {
  const IntervalFunction thirds{1.0 / 3, {{0, 1.0 / 3, yellow}}};
  TemporalEvaluator evaluator({thirds});
  for (const double base : {-1e300, -1e6, -1.0, 0.0, 1.0, 1e6, 1e15, 1e300}) {
    for (double time = base, i = 0; i < 50; ++i, time = std::nextafter(time, inf)) {
      EXPECT_EQ(evaluator.value(0, time, own), yellow) << time;
    }
  }
}

TEST(Intervals, LeaveTheOwnValueInGapsAndOutside) {
  const IntervalFunction gaps{2.0, {{0.5, 1, yellow}}};
  EXPECT_EQ(at(gaps, 0.25), own);
  EXPECT_EQ(at(gaps, 1), own);
  EXPECT_EQ(at(gaps, 2.75), yellow);
  const IntervalFunction once{std::nullopt, {{-2, -1, blue}, {3, 4, yellow}}};
  EXPECT_EQ(at(once, -2.5), own);
  EXPECT_EQ(at(once, -2), blue);
  EXPECT_EQ(at(once, -1), own);
  EXPECT_EQ(at(once, 3.5), yellow);
  EXPECT_EQ(at(once, 4), own);
}

TEST(Intervals, AreFoundAmongMany) {
  IntervalFunction many{1000.0, {}};
  for (int i = 0; i < 1000; ++i)
    many.intervals.push_back({1.0 * i, i + 0.5, TemporalValue(static_cast<float>(i))});
  TemporalEvaluator evaluator({many});
  for (int i = 0; i < 1000; ++i) {
    EXPECT_EQ(evaluator.value(0, i + 0.25, own), TemporalValue(static_cast<float>(i)));
    EXPECT_EQ(evaluator.value(0, i + 0.75, own), own);
  }
}

TEST(Keys, AreHeldAtBothEndsWithoutAPeriod) {
  const KeyFunction ramp{std::nullopt, {{1, TemporalValue(2)}, {3, TemporalValue(6)}}};
  EXPECT_EQ(at(ramp, -5).x, 2);
  EXPECT_EQ(at(ramp, 1).x, 2);
  EXPECT_EQ(at(ramp, 1.5).x, 3);
  EXPECT_EQ(at(ramp, 2.5).x, 5);
  EXPECT_EQ(at(ramp, 3).x, 6);
  EXPECT_EQ(at(ramp, 99).x, 6);
}

TEST(Keys, WrapAroundThePeriod) {
  // From 8 at 3 to 0 at 1 + 4: 2 units later, so 4 less a unit.
  const KeyFunction wave{4.0, {{1, TemporalValue(0)}, {3, TemporalValue(8)}}};
  EXPECT_EQ(at(wave, 2).x, 4);
  EXPECT_EQ(at(wave, 3.5).x, 6);
  EXPECT_EQ(at(wave, 4).x, 4);
  EXPECT_EQ(at(wave, 0).x, 4);
  EXPECT_EQ(at(wave, 0.5).x, 2);
  EXPECT_EQ(at(wave, -0.5).x, 6);
  EXPECT_EQ(at(wave, -3.5).x, 2);
  EXPECT_EQ(at(wave, 41).x, 0);
}

TEST(Keys, AtBothEndsOfThePeriodJumpThere) {
  const KeyFunction saw{2.0, {{0, TemporalValue(0)}, {2, TemporalValue(4)}}};
  EXPECT_EQ(at(saw, 1.5).x, 3);
  EXPECT_EQ(at(saw, 2).x, 0);
  EXPECT_EQ(at(saw, -0.5).x, 3);
}

TEST(Keys, OfOneTimeJump) {
  const KeyFunction jump{
      std::nullopt,
      {{0, TemporalValue(0)}, {1, TemporalValue(1)}, {1, TemporalValue(5)}, {2, TemporalValue(7)}}};
  EXPECT_EQ(at(jump, 0.5).x, 0.5F);
  EXPECT_EQ(at(jump, 1).x, 5);
  EXPECT_EQ(at(jump, 1.5).x, 6);
}

TEST(Keys, OfOneAreConstant) {
  EXPECT_EQ(at(KeyFunction{std::nullopt, {{3, blue}}}, -8), blue);
  EXPECT_EQ(at(KeyFunction{5.0, {{3, blue}}}, -8), blue);
  EXPECT_EQ(at(KeyFunction{5.0, {{3, blue}}}, 4), blue);
}

TEST(Formulas, GiveNumbersFractionsAndComponents) {
  const std::string sine = "0.5 + 0.5*sin(2*pi*t)";
  for (const double t : {-3.1, 0.0, 0.25, 1.7, 1e3}) {
    const double expected = 0.5 + 0.5 * std::sin(2 * std::numbers::pi * t);
    EXPECT_FLOAT_EQ(at(FormulaFunction{{sine}, {}, {}}, t).x, static_cast<float>(expected));
    const TemporalValue mixed = at(FormulaFunction{{sine}, yellow, blue}, t);
    EXPECT_FLOAT_EQ(mixed.x, static_cast<float>(1 - expected));
    EXPECT_FLOAT_EQ(mixed.z, static_cast<float>(expected));
  }
  EXPECT_EQ(at(FormulaFunction{{"t", "2*t", "t > 1 ? 4 : 0"}, {}, {}}, 3), TemporalValue(3, 6, 4));
}

TEST(Formulas, ThatAreNotFiniteLeaveTheOwnValueAndTheFirstFault) {
  TemporalEvaluator evaluator(
      {blink(), FormulaFunction{{"1/t"}, {}, {}}, FormulaFunction{{"1e39*t"}, {}, {}}});
  EXPECT_EQ(evaluator.fault().function, no_function);
  EXPECT_EQ(evaluator.value(1, 0.5, own).x, 2);
  EXPECT_EQ(evaluator.value(2, 1, own), own) << "beyond float";
  EXPECT_EQ(evaluator.value(1, 0, own), own);
  EXPECT_EQ(evaluator.fault().function, 2);
  EXPECT_EQ(evaluator.fault().time, 1);
}

TEST(Evaluator, KeepsTheOwnValueAtATimeThatIsNotFinite) {
  TemporalEvaluator evaluator({blink()});
  EXPECT_EQ(evaluator.value(0, std::nan(""), own), own);
  EXPECT_EQ(evaluator.fault().function, 0);
}

TEST(Evaluator, ReadsNumbersAndColours) {
  TemporalEvaluator evaluator({blink()});
  EXPECT_EQ(evaluator(TemporalNumber{0.5F}, 3), 0.5F);
  EXPECT_EQ(evaluator(TemporalNumber{0.5F, 0}, 0.75), 0);
  EXPECT_EQ(evaluator(TemporalColor{own}, 0), own);
  EXPECT_EQ(evaluator(TemporalColor{own, 0}, 0.75), blue);
}

TEST(Evaluator, AllocatesNothing) {
  TemporalEvaluator evaluator(
      {blink(), KeyFunction{2.0, {{0, yellow}, {1, blue}}},
       FormulaFunction{{"max(0, sin(2*pi*t)) + (t > 3 ? t^2 : abs(t))"}, yellow, blue},
       FormulaFunction{{"t", "sum(t, 1, 2)", "1/t"}, {}, {}}});
  const long before = allocations;
  float sum = 0;
  for (int i = -500; i < 500; ++i) {
    for (FunctionIndex f = 0; f < 4; ++f) sum += evaluator.value(f, 0.01 * i, own).x;
  }
  EXPECT_EQ(allocations - before, 0);
  EXPECT_TRUE(std::isfinite(sum));
}

TEST(Evaluator, CopiesServeOtherThreads) {
  const TemporalEvaluator original({FormulaFunction{{"t*t"}, {}, {}}});
  std::vector<std::thread> threads;
  std::vector<int> wrong(4, 0);
  for (std::size_t n = 0; n < wrong.size(); ++n) {
    threads.emplace_back([&original, &count = wrong[n]] {
      TemporalEvaluator copy(original);
      for (int i = 0; i < 2000; ++i) count += copy.value(0, i, own).x != static_cast<float>(i * i);
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_THAT(wrong, testing::Each(0));
}

TEST(Evaluator, RefusesAFunctionWithFaults) {
  EXPECT_THROW(TemporalEvaluator({FormulaFunction{{"2*"}, {}, {}}}), InputError);
}

TEST(FormulaFault, ReturnsNothingForFormulas) {
  for (const char* good :
       {"t", " 2 ", "pi", "t==1", "t != 1", "t>=1 ? 2 : 3", "max(1, t)", "-t^2", "1/t"}) {
    EXPECT_EQ(formula_fault(good), std::nullopt) << good;
  }
}

TEST(FormulaFault, NamesWhatIsWrong) {
  EXPECT_THAT(formula_fault("").value(), HasSubstr("empty"));
  EXPECT_THAT(formula_fault(" \t").value(), HasSubstr("empty"));
  EXPECT_THAT(formula_fault("t=5").value(), HasSubstr("assign"));
  EXPECT_THAT(formula_fault("pi = 3").value(), HasSubstr("assign"));
  EXPECT_THAT(formula_fault("1,2,3").value(), HasSubstr("list of 3"));
  EXPECT_THAT(formula_fault("2*x").value(), HasSubstr("\"x\""));
  EXPECT_THAT(formula_fault("sin(t))").value(), HasSubstr("position 6"));
  EXPECT_THAT(formula_fault("\"t\"").value(), HasSubstr("quotes"));
  EXPECT_THAT(formula_fault("t\xc3\xa9").value(), HasSubstr("ASCII"));
  EXPECT_THAT(formula_fault(std::string(20'001, '1')).value(), HasSubstr("longer"));
  for (const char* bad : {"_pi", "_e", "e", "rnd()", "sin()", "t t", "(1,2)", "t ? 1", "1e400"}) {
    EXPECT_NE(formula_fault(bad), std::nullopt) << bad;
  }
}

TEST(FormulaFault, BearsDeepNesting) {
  EXPECT_EQ(formula_fault(std::string(4000, '(') + "t" + std::string(4000, ')')), std::nullopt);
}

TEST(TemporalFaults, FindsNoneInGoodFunctions) {
  EXPECT_THAT(temporal_faults(blink()), IsEmpty());
  EXPECT_THAT(temporal_faults(KeyFunction{1.0, {{0, blue}, {0.5, blue}, {0.5, yellow}, {1, blue}}}),
              IsEmpty());
  EXPECT_THAT(temporal_faults(FormulaFunction{{"t"}, blue, yellow}), IsEmpty());
}

TEST(TemporalFaults, NamesThoseOfIntervals) {
  const auto faults = [](std::optional<double> period,
                         std::vector<IntervalFunction::Interval> intervals) {
    return temporal_faults(IntervalFunction{period, std::move(intervals)});
  };
  EXPECT_THAT(faults(0.0, {{0, 0.5, blue}}), Contains(HasSubstr("period is 0")));
  EXPECT_THAT(faults(-1.0, {{0, 0.5, blue}}), Contains(HasSubstr("period is -1")));
  EXPECT_THAT(faults(inf, {{0, 0.5, blue}}), Contains(HasSubstr("period is inf")));
  EXPECT_THAT(faults(1.0, {{0, 1.5, blue}}), Contains(HasSubstr("leaves the period")));
  EXPECT_THAT(faults(1.0, {{-0.5, 1, blue}}), Contains(HasSubstr("leaves the period")));
  EXPECT_THAT(faults(1.0, {{0.5, 0.5, blue}}), Contains(HasSubstr("empty")));
  EXPECT_THAT(faults(1.0, {{0, 0.6, blue}, {0.5, 1, blue}}), Contains(HasSubstr("overlaps")));
  EXPECT_THAT(faults(1.0, {{0.5, 1, blue}, {0, 0.5, blue}}), Contains(HasSubstr("before")));
  EXPECT_THAT(faults({}, {{0, inf, blue}}), Contains(HasSubstr("not finite")));
  EXPECT_THAT(faults({}, {{0, 1, TemporalValue(std::nanf(""))}}),
              Contains(HasSubstr("not finite")));
  EXPECT_THAT(faults({}, {}), Contains(HasSubstr("no intervals")));
  EXPECT_EQ(faults(-1.0, {{1, 0, blue}, {inf, 2, blue}}).size(), 3);
}

TEST(TemporalFaults, NamesThoseOfKeys) {
  const auto faults = [](std::optional<double> period, std::vector<KeyFunction::Key> keys) {
    return temporal_faults(KeyFunction{period, std::move(keys)});
  };
  EXPECT_THAT(faults(0.0, {{0, blue}}), Contains(HasSubstr("period is 0")));
  EXPECT_THAT(faults({}, {}), Contains(HasSubstr("no keys")));
  EXPECT_THAT(faults({}, {{1, blue}, {0, blue}}), Contains(HasSubstr("out of order")));
  EXPECT_THAT(faults({}, {{1, blue}, {1, blue}, {1, blue}}), Contains(HasSubstr("third")));
  EXPECT_THAT(faults(1.0, {{1.5, blue}}), Contains(HasSubstr("leaves the period")));
  EXPECT_THAT(faults({}, {{std::nan(""), blue}}), Contains(HasSubstr("not finite")));
}

TEST(TemporalFaults, NamesThoseOfFormulas) {
  EXPECT_THAT(temporal_faults(FormulaFunction{{}, {}, {}}), Contains(HasSubstr("0 formulas")));
  EXPECT_THAT(temporal_faults(FormulaFunction{{"t", "t"}, {}, {}}),
              Contains(HasSubstr("2 formulas")));
  EXPECT_THAT(temporal_faults(FormulaFunction{{"t="}, {}, {}}), Contains(HasSubstr("assign")));
  EXPECT_THAT(temporal_faults(FormulaFunction{{"t"}, blue, {}}),
              Contains(HasSubstr("from and to")));
}

}  // namespace
}  // namespace restframe
