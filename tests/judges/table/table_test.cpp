#include "tests/judges/table/table.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/judges/table/bounds.h"

namespace penpose::judges {
namespace {

Outcome outcome(double error, double stray, double right) {
  Outcome one;
  one.error = error;
  one.stray = stray;
  one.right = right;
  one.of = 1;
  return one;
}

std::vector<Judged> two_rigs() {
  return {{"intent", "a", "seen", {outcome(1, 0.1, 1), outcome(3, 0.3, 0), outcome(2, 0.2, 1)}},
          {"intent", "b", "seen", {outcome(10, 1, 1)}},
          {"intent", "c", "held_out", {outcome(7, 0, 0)}}};
}

TEST(JudgesTable, HasARowForEachRigAndATotalOfEachGroup) {
  const auto rows = table_of(two_rigs());
  ASSERT_EQ(rows.size(), 5U);
  EXPECT_EQ(rows[0].error_median, 2);
  EXPECT_EQ(rows[0].error_worst, 3);
  EXPECT_EQ(rows[0].right, 2);
  EXPECT_EQ(rows[3].rig, "all");
  EXPECT_EQ(rows[3].group, "seen");
  EXPECT_EQ(rows[3].cases, 4U);
  EXPECT_EQ(rows[3].error_median, 2.5);
  EXPECT_EQ(rows[3].stray_worst, 1);
  EXPECT_EQ(rows[4].group, "held_out");
  EXPECT_EQ(rows[4].error_worst, 7);
  EXPECT_FALSE(rows[4].still_worst);
}

TEST(JudgesTable, ComesBackFromItsFile) {
  for (const Row& row : table_of(two_rigs())) EXPECT_EQ(row_to_json(row_from_json(row_to_json(row))), row_to_json(row));
}

TEST(JudgesBounds, AWorseFigureFailsAndNamesItself) {
  const auto rows = table_of(two_rigs());
  const auto bounds = tightened(nlohmann::json::object(), rows);
  EXPECT_TRUE(broken(bounds, rows).empty());
  auto worse = two_rigs();
  worse[1].outcomes[0].error = 10.01;
  const auto lines = broken(bounds, table_of(worse));
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[0], "intent/seen/b: error_median is 10.010, not 10.000 or less");
  worse = two_rigs();
  worse[0].outcomes[0].right = 0;
  EXPECT_EQ(broken(bounds, table_of(worse)).size(), 2U);
}

TEST(JudgesBounds, AreTightenedAndNeverLoosened) {
  const auto bounds = tightened(nlohmann::json::object(), table_of(two_rigs()));
  auto other = two_rigs();
  other[0].outcomes[1].error = 2.5004;
  other[0].outcomes[0].right = 0;
  other[1].outcomes[0].stray = 2;
  const auto tighter = tightened(bounds, table_of(other));
  EXPECT_EQ(tighter["intent/seen/a"]["error_worst"], 2.501);
  EXPECT_EQ(tighter["intent/seen/a"]["right"], 2);
  EXPECT_EQ(tighter["intent/seen/b"]["stray_worst"], 1);
}

TEST(JudgesBounds, ARowThatComesOrGoesIsNoticed) {
  const auto rows = table_of(two_rigs());
  const auto bounds = tightened(nlohmann::json::object(), rows);
  EXPECT_EQ(broken(bounds, std::span(rows).first(4)).size(), 1U);
  EXPECT_EQ(broken(nlohmann::json::object(), rows).size(), rows.size());
  auto fewer = two_rigs();
  fewer[0].outcomes.pop_back();
  EXPECT_FALSE(broken(bounds, table_of(fewer)).empty());
}

}  // namespace
}  // namespace penpose::judges
