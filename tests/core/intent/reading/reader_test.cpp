#include "core/intent/reading/reader.h"

#include <cmath>
#include <gtest/gtest.h>

#include "tests/core/intent/face.h"

namespace penpose::intent {
namespace {

using tests::Face;
using tests::Line;

struct Desk {
  Face face = tests::usual_face();
  WholeModel whole = measure_whole_model(*face.rig);
  IntentProblem problem;

  Desk() {
    const rig::Pose answer = face.pose({{"cornerLeft", 0.6}, {"jawOpen", 0.4}});
    problem = face.problem({face.drawn(Face::mouth(), tests::shaken(face.seen(Face::mouth(), answer), 3, 1))});
    problem.known.push_back({Face::left_brow(), face.at(Face::left_brow(), face.pose({{"browLeft", 0.3}})), 0.01});
  }
  [[nodiscard]] Reader reader() const { return Reader::of(*face.rig, whole, problem); }
};

/// Of units by hand: a variable each.
Choice choice_of(std::vector<std::size_t> variables, std::vector<double> values) {
  Choice choice;
  choice.units = variables;
  choice.variables = std::move(variables);
  choice.values = std::move(values);
  return choice;
}

/// D of the drawn curve at a pose as the definition has it: squares of doubts over how the points slide, of which each
/// mode costs its square; the least over the modes by descending along one after the other.
double drawn_squares(const Desk& desk, const Matching& m, const rig::Pose& pose, double doubt) {
  const DrawnCurve& curve = desk.problem.drawn[0];
  const Line px = desk.face.seen(curve.reference, pose);
  std::array<double, k_modes> a{};
  const auto sum_at = [&] {
    double sum = 0;
    for (const double v : a) sum += v * v;
    for (std::size_t i = 0; i < px.size(); ++i) {
      const double w = m.weight[i] * 7.0 / (doubt * doubt);
      const PxPoint off = m.target[i] - px[i];
      double along = off.x * m.tangent[i].x + off.y * m.tangent[i].y - m.slid[i];
      const double across = -off.x * m.tangent[i].y + off.y * m.tangent[i].x;
      for (std::size_t k = 0; k < a.size(); ++k) along += m.modes[i][k] * a[k];
      sum += w * (along * along + across * across);
    }
    return sum;
  };
  for (int sweep = 0; sweep < 3000; ++sweep) {
    for (double& v : a) {
      // The sum is a parabola along each mode.
      const double middle = v;
      const double at = sum_at();
      v = middle + 1;
      const double ahead = sum_at();
      v = middle - 1;
      const double back = sum_at();
      v = middle + 0.5 * (back - ahead) / (ahead - 2 * at + back);
    }
  }
  return sum_at();
}

TEST(Reader, TheEnergyIsItsDefinitionWithTheSlidesAtTheirLeast) {
  const Desk desk;
  Reader reader = desk.reader();
  const std::size_t corner = desk.face.number("cornerLeft");
  const auto variable = [&](std::size_t p) {
    return static_cast<std::size_t>(std::find(reader.parameters().begin(), reader.parameters().end(), p) -
                                    reader.parameters().begin());
  };
  const Choice choice = choice_of({variable(corner)}, {0.45});
  Quadratic quadratic;
  reader.look(choice, true, quadratic);
  const rig::Pose pose = reader.pose_of(choice);
  EXPECT_NEAR(pose[corner], 0.45, 1e-12);

  const SlidingLine line(desk.problem.drawn[0].target);
  const Line seen = desk.face.seen(Face::mouth(), pose);
  const Matching m = line.match(seen, reader.alignments(0)[reader.aligned(0)], true, desk.problem.drawn[0].doubt_px);
  const double drawn = drawn_squares(desk, m, pose, desk.problem.drawn[0].doubt_px);
  EXPECT_NEAR(reader.squares_of(0, choice), drawn, 1e-6 * (1 + drawn));
  double known = 0;
  const auto at = desk.face.at(Face::left_brow(), pose);
  for (std::size_t i = 0; i < at.size(); ++i) {
    const double off = geometry::distance(at[i], desk.problem.known[0].target[i]) / 0.01;
    known += 7.0 * off * off / static_cast<double>(at.size());
  }
  // Mouth and brow lie apart: each has a scale of its own.
  const auto reach = [](double squares) { return 7.0 * std::log(1 + squares / 7.0); };
  EXPECT_NEAR(reader.energy(choice, 5),
              5 + reach(drawn) + reach(known) + inference::learned_weights().by[inference::Term::share] * 0.45 * 0.45,
              1e-6 * (drawn + known));
}

TEST(Reader, TheSquaresAreThoseOfTheEnergyNearThePose) {
  // Where the matching was looked at, the quadratic's value is D of both curves and next to nothing of the ray's.
  const Desk desk;
  Reader reader = desk.reader();
  const Choice choice = choice_of({0, 2}, {0.3, 0.1});
  Quadratic q;
  reader.look(choice, true, q);
  for (const std::size_t v : choice.variables) q.prepare_parts(v);
  double value = 0;
  for (std::size_t p = 0; p < q.part_count(); ++p) {
    value += q.part_constant(p);
    for (std::size_t i = 0; i < 2; ++i) {
      value -= 2 * q.part_pull(p, choice.variables[i]) * choice.values[i];
      for (std::size_t j = 0; j < 2; ++j) {
        value += q.part_curvature(p, choice.variables[i], choice.variables[j]) * choice.values[i] * choice.values[j];
      }
    }
  }
  double squares = reader.squares_of(0, choice);
  const auto at = desk.face.at(Face::left_brow(), reader.pose_of(choice));
  for (std::size_t i = 0; i < at.size(); ++i) {
    const double off = geometry::distance(at[i], desk.problem.known[0].target[i]) / 0.01;
    squares += 7.0 * off * off / static_cast<double>(at.size());
  }
  EXPECT_NEAR(value, squares, 0.01 * squares);
}

TEST(Reader, AnImageHasTheEnergyOfItsChoice) {
  const Desk desk;
  Reader reader = desk.reader();
  const Choice choice = choice_of({0, 2}, {0.3, 0.1});
  Quadratic q;
  reader.look({}, false, q);
  reader.look(choice, true, q);
  std::vector<double> image(q.right().begin(), q.right().end());
  for (double& v : image) v = -v;
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t k = 0; k < image.size(); ++k) image[k] += choice.values[i] * q.column(choice.variables[i])[k];
  }
  const double stiff = 7.0 * (0.3 * 0.3 + 0.1 * 0.1);
  const double energy = reader.energy(choice, 0);
  EXPECT_NEAR(reader.energy_of_image(image, q.rows()) + stiff, energy, 0.02 * energy);
}

TEST(Reader, VariablesAreWhatMovesTheCurves) {
  Desk desk;
  desk.problem.known.clear();
  Reader reader = desk.reader();
  for (const char* still : {"browLeft", "browRight"}) {
    EXPECT_EQ(std::find(reader.parameters().begin(), reader.parameters().end(), desk.face.number(still)),
              reader.parameters().end());
  }
  EXPECT_TRUE(std::is_sorted(reader.parameters().begin(), reader.parameters().end()));
  EXPECT_EQ(reader.parameters().size(), 7U);
  EXPECT_TRUE(reader.linear());
  EXPECT_EQ(reader.line_count(), 1U);
  desk.problem.free = {desk.face.number("cornerRight"), desk.face.number("browRight")};
  EXPECT_EQ(desk.reader().parameters().size(), 1U);
}

TEST(Reader, AControlThatMovesTheCurveByNextToNothingIsLeftOut) {
  Desk desk;
  desk.face.bump("hair", -0.35, -0.4, {0, 1e-7, 0});
  desk.face.ready();
  desk.whole = measure_whole_model(*desk.face.rig);
  desk.problem.start.push_back(0);
  desk.problem.free.push_back(9);
  Reader reader = desk.reader();
  EXPECT_EQ(std::count(reader.parameters().begin(), reader.parameters().end(), 9U), 0);
}

TEST(Reader, AControlIsItsShareOfTheWayThatIsLeft) {
  Desk desk;
  desk.problem.start[0] = 0.25;
  Reader reader = desk.reader();
  EXPECT_EQ(reader.choices().low[0], -0.25);
  EXPECT_EQ(reader.choices().high[0], 0.75);
  EXPECT_EQ(reader.pose_of(choice_of({0}, {0.5}))[0], 0.75);
  EXPECT_EQ(reader.pose_of(choice_of({0}, {9}))[0], 1) << "within all ranges";
  EXPECT_EQ(reader.pose_of(choice_of({0}, {-9}))[0], 0);
  EXPECT_EQ(reader.pose_of({}), desk.problem.start);
}

TEST(Reader, APairOfSidesIsAUnitBesideEachOfThem) {
  const Desk desk;
  Reader reader = desk.reader();
  std::size_t pairs = 0;
  for (const Unit& unit : reader.choices().units) {
    if (!unit.tied) {
      EXPECT_EQ(unit.count, 1U);
      continue;
    }
    ++pairs;
    EXPECT_EQ(desk.whole.partner[reader.parameters()[unit.members[0]]], reader.parameters()[unit.members[1]]);
  }
  EXPECT_EQ(pairs, 1U) << "the corners; the right brow moves no curve";
}

TEST(Reader, OnlyTheJointsOfTheChainAreUnits) {
  Face face;
  face.bump("shape", 0, 0, {0, 0.1, 0}).ready(tests::chain_skeleton(*face.mesh, 3, 0.4));
  const WholeModel whole = measure_whole_model(*face.rig);
  const auto row = Face::row(20, 20, 36);
  const IntentProblem problem = face.problem({face.drawn(row, face.seen(row, rig::rest_pose(*face.rig)))});
  Reader reader = Reader::of(*face.rig, whole, problem);
  EXPECT_FALSE(reader.linear());
  const std::size_t all = reader.choices().units.size();
  EXPECT_GT(all, 1U) << "a shape and what joints can do";
  const std::vector<std::size_t> chain{1, 2};
  reader.restrict_to(chain);
  EXPECT_LT(reader.choices().units.size(), all) << "the joint outside of the chain may not move";
  reader.restrict_to({});
  EXPECT_EQ(reader.choices().units.size(), all);
}

TEST(Reader, ABrowDoesNotSpeakForTheHeadThatCarriesIt) {
  Face face;
  face.bump("shape", 0, 0, {0, 0.3, 0}).ready(tests::chain_skeleton(*face.mesh, 3, 0.4));
  const WholeModel whole = measure_whole_model(*face.rig);
  const auto row = Face::row(20, 17, 23);
  Line line = face.seen(row, rig::rest_pose(*face.rig));
  for (PxPoint& p : line) p.y -= 20;
  const IntentProblem problem = face.problem({face.drawn(row, line)});
  Reader reader = Reader::of(*face.rig, whole, problem);
  EXPECT_FALSE(reader.limb());
  const std::size_t all = reader.choices().units.size();
  reader.leave_carriers(true);
  EXPECT_EQ(reader.choices().units.size(), 1U) << "the shape alone";
  reader.leave_carriers(false);
  EXPECT_EQ(reader.choices().units.size(), all);
  // Where the shape that could follow is locked, the joint that carries it is not meant for it.
  IntentProblem locked = problem;
  std::erase(locked.free, face.number("shape"));
  EXPECT_FALSE(Reader::of(*face.rig, whole, locked).limb());
}

TEST(Reader, WhatIsLeftIsTheDistanceToWhereThePointsGo) {
  Desk desk;
  const rig::Pose rest = rig::rest_pose(*desk.face.rig);
  Line line = desk.face.seen(Face::mouth(), rest);
  for (PxPoint& p : line) p.y -= 30;
  desk.problem.drawn[0].target = line;
  const auto left = desk.reader().left(rest);
  ASSERT_EQ(left.px.size(), 2U);
  EXPECT_NEAR(left.px[0], 30, 0.5);
  EXPECT_NEAR(left.units[0], 30 * desk.face.front.units_per_px(4.85), 0.03 * left.units[0]);
  double sum = 0;
  const auto at = desk.face.at(Face::left_brow(), rest);
  for (std::size_t i = 0; i < at.size(); ++i) sum += geometry::distance(at[i], desk.problem.known[0].target[i]);
  EXPECT_NEAR(left.units[1], sum / static_cast<double>(at.size()), 1e-12);
  EXPECT_NEAR(left.sum, left.units[0] * 17 + sum, 1e-9);
}

TEST(Reader, ALineRedrawnIsTheLineFromThenOn) {
  const Desk desk;
  Reader reader = desk.reader();
  const rig::Pose rest = rig::rest_pose(*desk.face.rig);
  Line line = desk.face.seen(Face::mouth(), rest);
  for (PxPoint& p : line) p.y += 12;
  reader.redraw(0, line, {});
  EXPECT_EQ(reader.alignments(0).size(), 1U);
  EXPECT_NEAR(reader.left(rest).px[0], 12, 0.3);
}

}  // namespace
}  // namespace penpose::intent
