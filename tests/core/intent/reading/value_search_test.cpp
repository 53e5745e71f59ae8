#include "core/intent/reading/value_search.h"

#include <gtest/gtest.h>

#include "core/intent/choosing/robust_selection.h"
#include "tests/core/intent/face.h"

namespace penpose::intent {
namespace {

using tests::Face;

struct Desk {
  Face face = tests::usual_face();
  WholeModel whole = measure_whole_model(*face.rig);
  IntentProblem problem;
  Reader reader;
  Quadratic quadratic;
  Choice choice;  ///< of least squares

  static IntentProblem made(const Face& face) {
    const rig::Pose answer = face.pose({{"cornerLeft", 0.6}, {"jawOpen", 0.4}});
    return face.problem({face.drawn(Face::mouth(), tests::shaken(face.seen(Face::mouth(), answer), 2, 1))});
  }
  Desk() : problem(made(face)), reader(Reader::of(*face.rig, whole, problem)) {
    const std::size_t jaw = variable("jawOpen");
    reader.look({}, true, quadratic);
    choice = fitted({variable("cornerLeft"), jaw});
    reader.look(choice, true, quadratic, choice.variables);
    choice = fitted(choice.units);
  }
  [[nodiscard]] ReadingCosts costs() const { return reader.reading_costs(); }
  [[nodiscard]] Choice fitted(std::vector<std::size_t> units) {
    const ReadingCosts own = costs();
    return RobustSelection(quadratic, own, reader.doubt()).fit(std::move(units));
  }
  [[nodiscard]] std::size_t variable(const char* name) const {
    const auto all = reader.parameters();
    return static_cast<std::size_t>(std::find(all.begin(), all.end(), face.number(name)) - all.begin());
  }
  [[nodiscard]] double energy(const Choice& at) { return reader.energy(at, costs().costs_of(at)); }
};

TEST(ValueSearch, TheEnergyNeverGrows) {
  Desk d;
  posing::SimplexWorkspace work;
  tests::Random random(3);
  for (int run = 0; run < 20; ++run) {
    Choice from = d.choice;
    for (double& v : from.values) v = random(0, 1);
    Choice found = from;
    const ReadingCosts selection = d.costs();
    search_values(d.reader, d.quadratic, selection, found, 300, work);
    EXPECT_LE(d.energy(found), d.energy(from) * (1 + 1e-3) + 0.05) << run;
    for (const double v : found.values) {
      EXPECT_GE(v, 0);
      EXPECT_LE(v, 1);
    }
  }
}

TEST(ValueSearch, FindsTheValuesAgainFromNearby) {
  Desk d;
  posing::SimplexWorkspace work;
  const ReadingCosts selection = d.costs();
  Choice best = d.choice;
  search_values(d.reader, d.quadratic, selection, best, 1000, work);
  Choice off = d.choice;
  off.values[0] -= 0.08;
  off.values[1] += 0.08;
  const double before = d.energy(off);
  search_values(d.reader, d.quadratic, selection, off, 1000, work);
  EXPECT_GT(before, d.energy(best) + 10);
  EXPECT_NEAR(d.energy(off), d.energy(best), 0.05);
  EXPECT_NEAR(off.values[0], best.values[0], 0.01);
  EXPECT_NEAR(off.costs, selection.costs_of(off), 1e-12);
}

TEST(ValueSearch, NothingChosenNeedsNoSearch) {
  Desk d;
  posing::SimplexWorkspace work;
  const ReadingCosts selection = d.costs();
  Choice nothing;
  EXPECT_EQ(search_values(d.reader, d.quadratic, selection, nothing, 100, work), 0U);
  EXPECT_TRUE(nothing.values.empty());
}

TEST(ValueSearch, KeepsToItsEvaluations) {
  Desk d;
  posing::SimplexWorkspace work;
  const ReadingCosts selection = d.costs();
  for (const std::size_t most : {10U, 40U, 200U}) {
    Choice choice = d.choice;
    choice.values[0] = 0.1;
    EXPECT_LE(search_values(d.reader, d.quadratic, selection, choice, most, work), most + choice.values.size() + 1);
  }
}

}  // namespace
}  // namespace penpose::intent
