#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>

#include "core/character/character.h"
#include "core/drawing/tool.h"
#include "tests/support/c_desk.h"
#include "tests/support/session_script.h"

namespace penpose::tests {
namespace {

std::vector<geometry::PxPoint> px_points(const std::vector<double>& px) {
  std::vector<geometry::PxPoint> out;
  for (std::size_t i = 0; i < px.size(); i += 2) out.push_back({px[i], px[i + 1]});
  return out;
}

/// The sheet as the library has it, in the hands of a session.
SessionScript session_of(CDesk& desk) {
  std::size_t size = 0;
  EXPECT_EQ(penpose_write(desk.open, desk.sheet, ".glb", nullptr, 0, &size, nullptr), PENPOSE_OK);
  std::vector<std::uint8_t> bytes(size);
  EXPECT_EQ(penpose_write(desk.open, desk.sheet, ".glb", bytes.data(), size, &size, nullptr), PENPOSE_OK);
  return SessionScript(character::Character::read(bytes).value().document());
}

TEST(CPosing, ACallAndTheSameInASessionGiveTheSameBits) {
  CDesk desk;
  SessionScript script = session_of(desk);
  ASSERT_EQ(desk.state(), script.editor().state().whole.hex());
  const document::View view{{{0, 0, 6}, {0, 0, 0}, {0, 1, 0}, 30}, {1000, 1000}};
  const auto over = desk.line(-0.5, 0.5, 0.5, 0.5);
  const auto to = desk.line(-0.5, 0.6, 0.5, 0.6);
  const auto keep = desk.line(-0.8, -0.5, 0.8, -0.5);
  const std::uint32_t curve = desk.draw(over);
  static_cast<void>(desk.draw(keep, PENPOSE_CONSTRAINT));
  ASSERT_EQ(
      penpose_target_stroke(desk.open, desk.sheet, curve, &desk.view, to.data(), nullptr, to.size() / 2, &desk.error),
      PENPOSE_OK)
      << desk.error.message;
  EXPECT_TRUE(script.perform(document::DrawReference{view, px_points(over)}).ok());
  EXPECT_TRUE(script.perform(document::DrawConstraint{view, px_points(keep)}).ok());
  EXPECT_TRUE(script.perform(document::DrawTarget{{curve}, view, px_points(to), {}}).ok());
  EXPECT_EQ(desk.state(), script.editor().state().whole.hex());
  EXPECT_GT(desk.pose()[0], 0.3);
  ASSERT_EQ(penpose_solve(desk.open, desk.sheet, PENPOSE_PRESET_DEFAULT, nullptr), PENPOSE_OK);
  EXPECT_TRUE(script.perform(document::SolvePose{}).ok());
  EXPECT_EQ(desk.state(), script.editor().state().whole.hex());
}

TEST(CPosing, EveryPresetReachesAKnownTarget) {
  for (const std::int32_t preset : {PENPOSE_PRESET_DEFAULT, PENPOSE_PRESET_EXACT, PENPOSE_PRESET_PAPER}) {
    CDesk desk;
    const std::uint32_t curve = desk.place_lift(0.6);
    ASSERT_EQ(penpose_solve(desk.open, desk.sheet, preset, &desk.error), PENPOSE_OK) << desk.error.message;
    EXPECT_NEAR(desk.pose()[0], 0.6, preset == PENPOSE_PRESET_PAPER ? 0.05 : 0.002);
    double distances[15];
    std::size_t count = 0;
    ASSERT_EQ(penpose_curve_distances(desk.open, desk.sheet, curve, distances, 15, &count, nullptr), PENPOSE_OK);
    ASSERT_EQ(count, 15U);
    EXPECT_LT(*std::max_element(distances, distances + count), preset == PENPOSE_PRESET_PAPER ? 0.02 : 0.001);
  }
}

TEST(CPosing, ACurveIsMadeAgainFromThePointsThatItIsGluedTo) {
  CDesk desk;
  const std::uint32_t drawn = desk.draw(desk.line(-0.5, 0.5, 0.5, 0.45));
  std::vector<penpose_mesh_point> points(40);
  std::size_t count = 0;
  ASSERT_EQ(penpose_curve_points(desk.open, desk.sheet, drawn, points.data(), points.size(), &count, &desk.error),
            PENPOSE_OK)
      << desk.error.message;
  ASSERT_EQ(count, 32U);
  std::uint32_t again = 0;
  ASSERT_EQ(penpose_curve_from_points(desk.open, desk.sheet, points.data(), count, PENPOSE_REFERENCE, &again, nullptr),
            PENPOSE_OK);
  std::array<std::vector<double>, 2> xyz{std::vector<double>(96), std::vector<double>(96)};
  for (int i = 0; i < 2; ++i) {
    ASSERT_EQ(
        penpose_curve_positions(desk.open, desk.sheet, i == 0 ? drawn : again, xyz[i].data(), 32, &count, nullptr),
        PENPOSE_OK);
  }
  EXPECT_EQ(xyz[0], xyz[1]);
}

TEST(CPosing, ALockedParameterStays) {
  CDesk desk;
  static_cast<void>(desk.place_lift(0.6));
  ASSERT_EQ(penpose_lock(desk.open, desk.sheet, "lift", 1, nullptr), PENPOSE_OK);
  ASSERT_EQ(penpose_solve(desk.open, desk.sheet, PENPOSE_PRESET_EXACT, nullptr), PENPOSE_OK);
  EXPECT_EQ(desk.pose()[0], 0);
  ASSERT_EQ(penpose_lock(desk.open, desk.sheet, "lift", 0, nullptr), PENPOSE_OK);
  ASSERT_EQ(penpose_solve(desk.open, desk.sheet, PENPOSE_PRESET_EXACT, nullptr), PENPOSE_OK);
  EXPECT_GT(desk.pose()[0], 0.5);
}

TEST(CPosing, PositionsAreTheRestPlusTheShapes) {
  CDesk desk;
  const double values[] = {0.5, -1};
  std::vector<double> xyz(desk.sheet_arrays.positions.size());
  std::vector<float> floats(xyz.size());
  ASSERT_EQ(penpose_evaluate(desk.open, desk.sheet, values, 2, xyz.data(), xyz.size() / 3, nullptr), PENPOSE_OK);
  ASSERT_EQ(penpose_evaluate_float(desk.open, desk.sheet, values, 2, floats.data(), floats.size() / 3, nullptr),
            PENPOSE_OK);
  std::vector<double> expected = desk.sheet_arrays.positions;
  for (std::size_t shape = 0; shape < 2; ++shape) {
    const auto& vertices = desk.sheet_arrays.vertices[shape];
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        expected[3 * vertices[i] + axis] += values[shape] * double{desk.sheet_arrays.deltas[shape][3 * i + axis]};
    }
  }
  for (std::size_t i = 0; i < xyz.size(); ++i) {
    ASSERT_NEAR(xyz[i], expected[i], 1e-12) << i;
    ASSERT_EQ(floats[i], static_cast<float>(xyz[i])) << i;
  }
}

TEST(CPosing, AShapeOfAllVerticesIsThatOfThoseThatMove) {
  CDesk desk;
  SheetArrays dense;
  std::vector<float> all(dense.positions.size(), 0.0F);
  for (std::size_t i = 0; i < dense.vertices[0].size(); ++i)
    std::copy_n(&dense.deltas[0][3 * i], 3, &all[3 * std::size_t{dense.vertices[0][i]}]);
  dense.shapes[0] = {"lift", 0, 1, all.size() / 3, nullptr, all.data()};
  penpose_handle made = 0;
  ASSERT_EQ(penpose_character_from_arrays(desk.open, &dense.arrays, &made, &desk.error), PENPOSE_OK)
      << desk.error.message;
  EXPECT_EQ(desk.state(made), desk.state());
}

TEST(CPosing, AJointTurnsWhatItCarries) {
  CDesk desk;
  SheetArrays arrays;
  penpose_joint joint{"neck", -1, 1, {0, 0, 0}, {0, 0, 0, 1}, {1, 1, 1}, {}, {-1, -1, -1}, {1, 1, 1}};
  for (const std::size_t i : {0, 5, 10, 15}) joint.inverse_bind[i] = 1;
  const std::vector<std::uint32_t> joint_of(arrays.arrays.vertex_count, 0);
  const std::vector<double> weight_of(arrays.arrays.vertex_count, 1.0);
  arrays.arrays.joint_count = 1;
  arrays.arrays.joints = &joint;
  arrays.arrays.influences = 1;
  arrays.arrays.joint_of = joint_of.data();
  arrays.arrays.weight_of = weight_of.data();
  penpose_handle made = 0;
  ASSERT_EQ(penpose_character_from_arrays(desk.open, &arrays.arrays, &made, &desk.error), PENPOSE_OK)
      << desk.error.message;
  std::size_t turn = 0;
  ASSERT_EQ(penpose_find_parameter(desk.open, made, "neck.rz", &turn, nullptr), PENPOSE_OK);
  std::vector<double> values = desk.pose(made);
  values[turn] = 0.5;
  std::vector<double> xyz(arrays.positions.size());
  ASSERT_EQ(penpose_evaluate(desk.open, made, values.data(), values.size(), xyz.data(), xyz.size() / 3, nullptr),
            PENPOSE_OK);
  for (std::size_t v = 0; v < xyz.size(); v += 3) {
    const double x = arrays.positions[v];
    const double y = arrays.positions[v + 1];
    EXPECT_NEAR(xyz[v], std::cos(0.5) * x - std::sin(0.5) * y, 1e-9);
    EXPECT_NEAR(xyz[v + 1], std::sin(0.5) * x + std::cos(0.5) * y, 1e-9);
  }
}

TEST(CPosing, APreviewFollowsAndChangesNothing) {
  CDesk desk;
  const std::uint32_t curve = desk.draw(desk.line(-0.5, 0.5, 0.5, 0.5));
  const std::string before = desk.state();
  penpose_handle live = 0;
  ASSERT_EQ(penpose_live_begin(desk.open, desk.sheet, curve, &desk.view, &live, nullptr), PENPOSE_OK);
  const auto to = desk.line(-0.5, 0.6, 0.5, 0.6);
  double values[2] = {-1, -1};
  std::int32_t moved = -1;
  ASSERT_EQ(penpose_live_follow(desk.open, live, to.data(), 1, values, 2, &moved, nullptr), PENPOSE_OK);
  EXPECT_EQ(moved, 0);
  EXPECT_EQ(values[0], 0);
  for (std::size_t count = 2; count <= to.size() / 2; ++count)
    ASSERT_EQ(penpose_live_follow(desk.open, live, to.data(), count, values, 2, &moved, nullptr), PENPOSE_OK);
  EXPECT_NEAR(values[0], 0.5, 0.1);
  EXPECT_EQ(desk.state(), before);
  // It lives on without its character.
  ASSERT_EQ(penpose_free(desk.open, desk.sheet, nullptr), PENPOSE_OK);
  EXPECT_EQ(penpose_live_follow(desk.open, live, to.data(), to.size() / 2, values, 2, &moved, nullptr), PENPOSE_OK);
}

TEST(CPosing, ACopyIsAPlaceToGoBackTo) {
  CDesk desk;
  penpose_handle kept = 0;
  ASSERT_EQ(penpose_character_copy(desk.open, desk.sheet, &kept, nullptr), PENPOSE_OK);
  const std::string before = desk.state();
  ASSERT_EQ(penpose_set_parameter(desk.open, desk.sheet, "lean", -0.5, nullptr), PENPOSE_OK);
  EXPECT_NE(desk.state(), before);
  EXPECT_EQ(desk.state(kept), before);
}

TEST(CPosing, ASketchedDeformerIsAParameterThatMoves) {
  CDesk desk;
  const auto around = [&](double r) {
    std::vector<double> px;
    for (const auto& part :
         {desk.line(r, 0, 0, r), desk.line(0, r, -r, 0), desk.line(-r, 0, 0, -r), desk.line(0, -r, r, 0)})
      px.insert(px.end(), part.begin(), part.end() - 2);
    return px;
  };
  const CSketch drawn{around(0.8), around(0.4), desk.line(-0.3, 0, 0.3, 0), desk.line(-0.3, 0.3, 0.3, 0.3)};
  penpose_sketch sketch = drawn.on(desk);
  sketch.mode = PENPOSE_MODE_TRANSLATE;
  ASSERT_EQ(penpose_sketch_deformer(desk.open, desk.sheet, &sketch, &desk.error), PENPOSE_OK) << desk.error.message;
  ASSERT_EQ(penpose_set_parameter(desk.open, desk.sheet, "up", 1, &desk.error), PENPOSE_OK) << desk.error.message;
  std::vector<double> xyz(desk.sheet_arrays.positions.size());
  ASSERT_EQ(penpose_evaluate(desk.open, desk.sheet, nullptr, 0, xyz.data(), xyz.size() / 3, nullptr), PENPOSE_OK);
  EXPECT_NEAR(xyz[3 * 112 + 1], 0.3, 0.03) << "the middle of the sheet goes up by what was drawn";
  EXPECT_EQ(xyz[1], desk.sheet_arrays.positions[1]) << "its corner stays";
  // A second one of that name is refused before anything is begun.
  const std::string before = desk.state();
  EXPECT_EQ(penpose_sketch_deformer(desk.open, desk.sheet, &sketch, &desk.error), PENPOSE_REFUSED);
  EXPECT_EQ(desk.state(), before);
}

}  // namespace
}  // namespace penpose::tests
