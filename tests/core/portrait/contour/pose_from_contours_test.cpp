#include "core/portrait/contour/pose_from_contours.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numeric>

#include "core/character/demo_head.h"
#include "core/curve/polyline.h"
#include "core/portrait/contour/seen_contours.h"
#include "tests/support/models/stick_figure.h"

// Known poses by their contours alone.

namespace penpose::portrait {
namespace {

using Lines = std::vector<std::vector<PxPoint>>;

/// A rig, how it is seen, and what is drawn of it.
struct ContourStage {
  std::shared_ptr<const rig::CharacterRig> rig;
  intent::WholeModel whole;
  rig::Pose rest;
  geometry::Camera camera;
  std::vector<std::size_t> free;

  ContourStage(std::shared_ptr<const rig::CharacterRig> of, double yaw)
      : rig(std::move(of)),
        whole(intent::measure_whole_model(*rig)),
        rest(rig::rest_pose(*rig)),
        camera(geometry::frame_box(rig->mesh().rest_box(), {1000, 1000}, yaw)),
        free(rest.size()) {
    std::iota(free.begin(), free.end(), 0U);
  }
  [[nodiscard]] std::vector<geometry::ModelPoint> places(const rig::Pose& pose) const {
    std::vector<geometry::ModelPoint> out(rig->vertex_count());
    rig->evaluate(pose, out);
    return out;
  }
  /// The contours of a pose of 50 px or more, with a tremor of 2 px.
  [[nodiscard]] Lines drawn(const rig::Pose& pose) const {
    SeenContours seen(*rig, rig->mesh(), camera);
    seen.look(pose);
    Lines out;
    for (const SeenContour& contour : seen.lines()) {
      if (contour.lengths.back() < 50.0) continue;
      auto line = curve::resample<PxPoint>(contour.px, static_cast<std::size_t>(contour.lengths.back() / 8.0)).value();
      for (std::size_t i = 0; i < line.size(); ++i) {
        const double t = 0.25 * static_cast<double>(i);
        line[i] = line[i] + PxPoint{2.0 * std::sin(1.0 + t), 2.0 * std::sin(2.0 + 0.8 * t)};
      }
      out.push_back(std::move(line));
    }
    return out;
  }
  /// Of those, the points that lie `px` or more from where every contour is at rest.
  [[nodiscard]] Lines drawn_where_moved(const rig::Pose& pose, double px) const {
    Lines out;
    const Lines at_rest = drawn(rest);
    for (const auto& line : drawn(pose)) {
      out.emplace_back();
      for (const PxPoint& p : line) {
        double nearest = 1e300;
        for (const auto& other : at_rest) {
          for (const PxPoint& q : other) nearest = std::min(nearest, geometry::distance(p, q));
        }
        if (nearest >= px) {
          out.back().push_back(p);
        } else if (!out.back().empty()) {
          out.emplace_back();
        }
      }
    }
    std::erase_if(out, [](const auto& line) { return line.size() < 6; });
    return out;
  }
  [[nodiscard]] base::Result<ContourPose> pose(Lines lines) const {
    const ContourDrawing drawing{std::move(lines), 1000, 1000, {}, {}};
    return pose_from_contours(*rig, rig->mesh(), whole, drawing, std::span(&camera, 1), rest, free);
  }
  /// How far off a pose is, as a share of how far the one that was drawn moves the model.
  [[nodiscard]] double error(const rig::Pose& found, const rig::Pose& meant) const {
    const auto a = places(found), b = places(meant), c = places(rest);
    double off = 0, way = 0;
    for (std::size_t v = 0; v < a.size(); ++v) {
      off += std::pow(geometry::distance(a[v], b[v]), 2);
      way += std::pow(geometry::distance(c[v], b[v]), 2);
    }
    return std::sqrt(off / way);
  }
};

/// The stick figure with its left arm raised or lowered about the view's direction.
struct StickContours : ContourStage {
  tests::StickFigure man = tests::stick_man();
  StickContours() : ContourStage(tests::stick_man().rig(), 0) {}
  [[nodiscard]] rig::Pose arm(double angle) const {
    rig::Pose pose = rest;
    const glm::dvec3 angles = man.angles(6, {0, 0, 1}, angle);
    for (int k = 0; k < 3; ++k) pose[18 + static_cast<std::size_t>(k)] = angles[k];
    return pose;
  }
};

TEST(PoseFromContours, AnArmAgainstTheBackgroundFollowsItsOutline) {
  const StickContours stage;
  for (const double angle : {0.35, 0.9, -0.6}) {
    const rig::Pose meant = stage.arm(angle);
    for (const Lines& lines : {stage.drawn(meant), stage.drawn_where_moved(meant, 6)}) {
      const auto posed = stage.pose(lines);
      ASSERT_TRUE(posed) << posed.error().what;
      EXPECT_LE(stage.error(posed->pose, meant), 0.1) << angle << " by " << lines.size() << " lines";
      for (std::size_t p = 0; p < meant.size(); ++p) {
        if (p / 3 < 6 || p / 3 > 8) {
          EXPECT_EQ(posed->pose[p], stage.rest[p]) << angle << ": " << p << " is no part of the arm";
        }
      }
    }
  }
}

TEST(PoseFromContours, AJawOpensInProfile) {
  const document::Model head = character::make_demo_head().value();
  const ContourStage stage(head.rig, 90);
  for (const double jaw : {0.4, 0.8}) {
    rig::Pose meant = stage.rest;
    meant[rig::find_parameter(stage.rig->parameters(), "jaw").value()] = jaw;
    for (const Lines& lines : {stage.drawn(meant), stage.drawn_where_moved(meant, 4)}) {
      const auto posed = stage.pose(lines);
      ASSERT_TRUE(posed) << posed.error().what;
      EXPECT_LE(stage.error(posed->pose, meant), 0.12) << jaw << " by " << lines.size() << " lines";
    }
  }
}

TEST(PoseFromContours, TheOutlineAtRestMovesNothingWhereverItLies) {
  const StickContours stage;
  const Lines lines = stage.drawn(stage.rest);
  const auto posed = stage.pose(lines);
  ASSERT_TRUE(posed);
  EXPECT_EQ(posed->pose, stage.rest);
  EXPECT_EQ(posed->explained, std::vector<bool>(lines.size(), true));
  Lines small = lines;
  for (auto& line : small) {
    for (PxPoint& p : line) p = PxPoint{620, 90} + p * 0.4;
  }
  const auto laid = stage.pose(small);
  ASSERT_TRUE(laid);
  EXPECT_EQ(laid->pose, stage.rest);
  EXPECT_EQ(laid->explained, std::vector<bool>(lines.size(), true));
}

TEST(PoseFromContours, ARaisedArmDrawnElsewhereOnTheSheet) {
  const StickContours stage;
  const rig::Pose meant = stage.arm(0.5);
  Lines lines = stage.drawn(meant);
  for (auto& line : lines) {
    for (PxPoint& p : line) p = PxPoint{100, 350} + p * 0.6;
  }
  const auto posed = stage.pose(lines);
  ASSERT_TRUE(posed);
  EXPECT_LE(stage.error(posed->pose, meant), 0.2);
}

TEST(PoseFromContours, LinesThatAreNoContourMoveNothing) {
  const StickContours stage;
  const Lines lines{{{20, 20}, {60, 40}, {30, 90}, {80, 120}}, {{900, 930}, {960, 990}}};
  const auto posed = stage.pose(lines);
  ASSERT_TRUE(posed);
  EXPECT_EQ(posed->pose, stage.rest);
  EXPECT_EQ(posed->explained, (std::vector<bool>{false, false}));
}

TEST(PoseFromContours, ScribblesOverTheModelMoveNothing) {
  const StickContours stage;
  Lines lines;
  for (int l = 0; l < 12; ++l) {
    lines.emplace_back();
    for (int i = 0; i < 80; ++i)
      lines.back().push_back({500 + 450 * std::sin(1.7 * i * (1 + l % 3) + l), 500 + 450 * std::cos(2.3 * i + 2 * l)});
  }
  const auto posed = stage.pose(lines);
  ASSERT_TRUE(posed);
  EXPECT_EQ(posed->pose, stage.rest);
  EXPECT_EQ(posed->explained, std::vector<bool>(lines.size(), false));
}

TEST(PoseFromContours, TheSameLinesGiveTheSameBits) {
  const StickContours stage;
  const Lines lines = stage.drawn(stage.arm(0.7));
  EXPECT_EQ(stage.pose(lines)->pose, stage.pose(lines)->pose);
}

TEST(PoseFromContours, WhatCannotBeReadIsSaid) {
  const StickContours stage;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto failure = [&](Lines lines) {
    const auto posed = stage.pose(std::move(lines));
    return posed ? std::string("posed") : posed.error().line("x");
  };
  EXPECT_NE(failure({}).find("it has no lines"), std::string::npos);
  EXPECT_NE(failure({{{5, 5}, {5, 5}}}).find("a line has no length"), std::string::npos);
  EXPECT_NE(failure({{{5, 5}}}).find("a line has no length"), std::string::npos);
  EXPECT_NE(failure({{{5, 5}, {nan, 5}}}).find("a point is not on a sheet"), std::string::npos);
  EXPECT_NE(failure(Lines(61, {{5, 5}, {9, 9}})).find("61 contour lines"), std::string::npos);
  // A sheet that faces the camera has no contour.
  mesh::MeshSource source;
  source.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  source.triangles = {{0, 1, 2}, {0, 2, 3}};
  const auto flat = rig::CharacterRig::make(mesh::TriangleMesh::build(std::move(source)).value(), {}, nullptr).value();
  const ContourStage sheet(flat, 0);
  const auto posed = sheet.pose({{{100, 100}, {900, 120}}});
  ASSERT_FALSE(posed);
  EXPECT_EQ(posed.error().what, "the model has no contour in this view");
}

TEST(PoseFromContours, WhatOtherLinesHoldStays) {
  const StickContours stage;
  // The arm's outline is drawn raised, but what was read before says that its hand is where it is.
  ContourDrawing drawing{stage.drawn_where_moved(stage.arm(0.3), 6), 1000, 1000, {}, {}};
  for (const std::uint32_t v : stage.man.along(8)) drawing.kept.push_back(posing::at_vertex(v));
  drawing.placement = Placement{};
  const auto posed = pose_from_contours(*stage.rig, stage.rig->mesh(), stage.whole, drawing,
                                        std::span(&stage.camera, 1), stage.rest, stage.free);
  ASSERT_TRUE(posed);
  const auto at = stage.places(posed->pose), rest = stage.places(stage.rest);
  for (const std::uint32_t v : stage.man.along(8))
    EXPECT_LT(geometry::distance(*stage.camera.project(at[v]), *stage.camera.project(rest[v])), 8.0);
}

}  // namespace
}  // namespace penpose::portrait
