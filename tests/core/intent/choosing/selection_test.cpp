#include "core/intent/choosing/selection.h"

#include <cmath>
#include <gtest/gtest.h>

#include "tests/support/models/test_rigs.h"

namespace penpose::intent {
namespace {

using Column = std::vector<double>;
using Units = std::vector<std::size_t>;

/// Columns and what is asked of them, each variable a unit of its own unless told.
struct Case {
  Quadratic quadratic;
  Choices choices;
  Costs costs;

  Case(const std::vector<Column>& columns, const Column& right) {
    quadratic.reset(columns.size(), right.size(), 0);
    for (std::size_t j = 0; j < columns.size(); ++j) {
      std::copy(columns[j].begin(), columns[j].end(), quadratic.column(j).begin());
      Unit unit;
      unit.members[0] = j;
      choices.units.push_back(unit);
      choices.low.push_back(0);
      choices.high.push_back(1);
      choices.movement.push_back(1);
      choices.stiffness.push_back(0.5);
    }
    std::copy(right.begin(), right.end(), quadratic.right().begin());
    quadratic.finish();
  }
  void pair(std::size_t a, std::size_t b) {
    Unit unit;
    unit.members = {a, b, 0};
    unit.count = 2;
    unit.tied = true;
    choices.units.push_back(unit);
  }
  [[nodiscard]] Selection selection() { return {quadratic, choices, costs}; }
  [[nodiscard]] Choice select(std::size_t most = 20) {
    Selection s = selection();
    return s.select(s.fit({}), most);
  }
};

TEST(Selection, NothingMovesWhereNothingIsAsked) {
  Case c({{30, 0}, {0, 30}}, {0, 0});
  const Choice choice = c.select();
  EXPECT_TRUE(choice.units.empty());
  EXPECT_EQ(choice.energy, 0);
}

TEST(Selection, WithinTheDoubtNothingMovesAndBeyondItOneControlDoes) {
  // One unit of the right side is a doubt.
  EXPECT_TRUE(Case({{30, 0}, {0, 30}}, {2, 2}).select().units.empty());
  EXPECT_EQ(Case({{30, 0}, {0, 30}}, {20, 2}).select().units, Units{0});
}

TEST(Selection, OneOfTwoNearlyEqualControlsIsChosenRatherThanBoth) {
  Case c({{30, 10, 0}, {29.5, 10.5, 0.4}}, {15.2, 5.1, 0.3});
  EXPECT_EQ(c.select().units.size(), 1U);
}

TEST(Selection, TwoControlsAreBothChosenWhereEachIsAskedFor) {
  EXPECT_EQ(Case({{30, 1}, {1, 30}}, {20, 20}).select().units, (Units{0, 1}));
}

TEST(Selection, OfTwoThatFitAlikeTheOneThatMovesLessOfTheModelIsMeant) {
  Case c({{30, 0}, {30, 0}}, {20, 0});
  c.choices.movement = {9, 0.5};
  EXPECT_EQ(c.select().units, Units{1});
  c.choices.movement = {0.5, 9};
  EXPECT_EQ(c.select().units, Units{0});
}

TEST(Selection, OpposedControlsAreNotBothUp) {
  // The second undoes the first; what is asked lies to the side of the first.
  EXPECT_EQ(Case({{30, 3}, {-30, 3}}, {18, 2}).select().units, Units{0});
  EXPECT_EQ(Case({{30, 3}, {-30, 3}}, {-18, 2}).select().units, Units{1});
}

TEST(Selection, ValuesAreLeastSquaresWithinTheirRanges) {
  Case c({{10, 2, 0}, {3, 10, 1}, {0, 1, 10}}, {30, -9, 4});
  Selection s = c.selection();
  const Choice choice = s.fit({0, 1, 2});
  // No step along any axis within the ranges lowers the squares.
  const auto squares = [&](const std::vector<double>& z) {
    const std::vector<Column> columns{{10, 2, 0}, {3, 10, 1}, {0, 1, 10}};
    const Column right{30, -9, 4};
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      double off = -right[i];
      for (std::size_t j = 0; j < 3; ++j) off += columns[j][i] * z[j];
      sum += off * off + 0.5 * z[i] * z[i];
    }
    return sum;
  };
  const double found = squares(choice.values);
  EXPECT_NEAR(choice.energy - choice.costs, found, 1e-9);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_GE(choice.values[i], 0);
    EXPECT_LE(choice.values[i], 1);
    for (const double step : {-1e-3, 1e-3}) {
      auto z = choice.values;
      z[i] = std::clamp(z[i] + step, 0.0, 1.0);
      EXPECT_GE(squares(z), found - 1e-9);
    }
  }
  EXPECT_EQ(choice.values[0], 1) << "asked for three times its range";
  EXPECT_EQ(choice.values[1], 0) << "asked to go below it";
}

TEST(Selection, CostsAreWhatTheFormulaSays) {
  Case c({{30, 0}, {0, 30}, {10, 10}}, {20, 20});
  c.choices.movement = {0.5, 2, 3};
  c.pair(0, 1);
  Selection s = c.selection();
  const Choice one = s.fit({2});
  const double usual = 8 + std::log(1 + 200.0) + 4 * std::log(1 + 3 * one.values[0] / 0.2);
  ASSERT_EQ(one.values[0], 1) << "as far as it can";
  EXPECT_NEAR(one.costs, usual + 8, 1e-9);
  EXPECT_NEAR(s.costs_of(one), usual, 1e-9);
  c.costs.limit = 0;
  EXPECT_NEAR(c.selection().fit({2}).costs, usual, 1e-9);
  const Choice pair = s.fit({3});
  ASSERT_NEAR(pair.values[0], pair.values[1], 1e-12) << "drawn alike";
  const double way = (0.5 + 2) * pair.values[0] / 2;
  EXPECT_NEAR(pair.costs, 8 + std::log(1 + 900.0) + 4 * std::log(1 + way / 0.2), 1e-9);
  EXPECT_NEAR(s.costs_of(pair), pair.costs, 1e-12);
}

TEST(Selection, TheEnergyCountsWhatTheSidesOfAPairDifferBy) {
  Case c({{30, 0}, {0, 20}}, {20, 5});
  c.pair(0, 1);
  const Choice pair = c.selection().fit({2});
  const double a = pair.values[0];
  const double b = pair.values[1];
  ASSERT_GT(a - b, 0.1);
  const double squares = (30 * a - 20) * (30 * a - 20) + (20 * b - 5) * (20 * b - 5) + 0.5 * (a * a + b * b);
  const double costs = 8 + std::log(1 + 900.0) + 4 * std::log(1 + (a + b) / 2 / 0.2);
  EXPECT_NEAR(pair.energy, squares + costs + 40 * (a - b) * (a - b), 1e-9);
}

TEST(Selection, LeftAndRightMoveTogetherWhereBothAreDrawnAndAloneWhereOneIs) {
  const std::vector<Column> sides{{30, 0}, {0, 30}};
  Case both(sides, {18, 17});
  both.pair(0, 1);
  const Choice together = both.select();
  EXPECT_EQ(together.units, Units{2});
  EXPECT_NEAR(together.values[0], together.values[1], 0.05);
  Case left(sides, {18, 0});
  left.pair(0, 1);
  EXPECT_EQ(left.select().units, Units{0});
  Case wink(sides, {25, 6});
  wink.pair(0, 1);
  const Choice unlike = wink.select();
  EXPECT_GT(unlike.values[0], 0.7) << "drawn unlike, the sides differ";
}

TEST(Selection, APairIsNotChosenBesideItsOwnSide) {
  tests::Random random(4);
  for (int run = 0; run < 30; ++run) {
    std::vector<Column> columns(4, Column(6));
    for (auto& column : columns) {
      for (double& v : column) v = random(-30, 30);
    }
    Column right(6);
    for (double& v : right) v = random(-40, 40);
    Case c(columns, right);
    c.pair(0, 1);
    c.pair(2, 3);
    const Choice choice = c.select();
    EXPECT_TRUE(std::adjacent_find(choice.variables.begin(), choice.variables.end()) == choice.variables.end());
  }
}

TEST(Selection, NoControlAddedTakenOutOrExchangedWouldBeBetter) {
  tests::Random random(8);
  for (int run = 0; run < 40; ++run) {
    constexpr std::size_t k_count = 8;
    std::vector<Column> columns(k_count, Column(10));
    for (auto& column : columns) {
      for (double& v : column) v = random(-20, 20);
    }
    Column right(10, 0.0);
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t i = 0; i < 10; ++i) right[i] += columns[j][i] * random(0.2, 0.8) + random(-1, 1);
    }
    Case c(columns, right);
    const Choice best = c.select();
    Selection s = c.selection();
    const auto expect_no_better = [&](const Units& units) {
      EXPECT_GE(s.fit(units).energy, best.energy - 1e-6) << run;
    };
    for (std::size_t out = 0; out <= best.units.size(); ++out) {
      Units fewer = best.units;
      if (out < fewer.size()) fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(out));
      expect_no_better(fewer);
      for (std::size_t in = 0; in < k_count; ++in) {
        if (std::find(fewer.begin(), fewer.end(), in) != fewer.end()) continue;
        Units other = fewer;
        other.insert(std::lower_bound(other.begin(), other.end(), in), in);
        expect_no_better(other);
      }
    }
  }
}

TEST(Selection, NoMoreUnitsMoveThanAllowed) {
  Case c({{40, 0, 0}, {0, 40, 0}, {0, 0, 40}}, {30, 25, 20});
  EXPECT_EQ(c.select(3).units.size(), 3U);
  EXPECT_EQ(c.select(1).units, Units{0});
  EXPECT_TRUE(c.select(0).units.empty());
}

TEST(Selection, RivalsLieWithinTheWindowTheBestFirst) {
  Case c({{30, 1}, {30, -1}, {29, 4}, {0, 30}}, {20, 0.3});
  Selection s = c.selection();
  s.set_rivals(6, 12);
  const Choice best = s.select(s.fit({}), 20);
  ASSERT_GE(s.rivals().size(), 2U);
  EXPECT_LE(s.rivals().size(), 6U);
  double before = best.energy;
  for (const Choice& rival : s.rivals()) {
    EXPECT_GE(rival.energy, before - 1e-9);
    EXPECT_LE(rival.energy, best.energy + 12);
    EXPECT_NE(rival.units, best.units);
    before = rival.energy;
  }
}

TEST(Selection, AControlThatDoesNothingDoesNoHarm) {
  Case c({{0, 0}, {30, 0}}, {20, 0});
  c.choices.stiffness[0] = 0;
  const Choice choice = c.select();
  EXPECT_EQ(choice.units, Units{1});
  Selection s = c.selection();
  EXPECT_EQ(s.fit({0}).values[0], 0);
}

}  // namespace
}  // namespace penpose::intent
