#include "core/portrait/sketch/pose_over_face.h"

#include <gtest/gtest.h>
#include <numeric>

#include "core/character/demo_head.h"
#include "core/document/features/feature_curves.h"
#include "core/portrait/pose_from_drawing.h"

namespace penpose::portrait {
namespace {

/// The built-in head, whose features are drawn where a pose has them.
struct Head {
  document::Model model = character::make_demo_head().value();
  intent::WholeModel whole = intent::measure_whole_model(*model.rig);
  std::vector<FeatureCurve> curves = document::feature_curves_of(model, whole, {}).value().curves;
  rig::Pose rest = rig::rest_pose(*model.rig);
  geometry::Camera camera = camera_of_drawing(*model.rig, curves, rest, 0);

  [[nodiscard]] std::size_t control(const char* name) const {
    return rig::find_parameter(model.rig->parameters(), name).value();
  }
  [[nodiscard]] std::size_t curve(const std::string& name) const {
    const auto names = names_of(curves);
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
  }
  [[nodiscard]] DrawnLine line(std::size_t curve, const rig::Pose& pose) const {
    std::vector<geometry::ModelPoint> places(model.rig->vertex_count());
    model.rig->evaluate(pose, places);
    DrawnLine out;
    for (const posing::CurvePoint& point : curves[curve].points) {
      geometry::ModelPoint p(0);
      for (std::size_t k = 0; k < 3; ++k) p += places[point.vertex[k]] * point.weight[k];
      out.push_back(camera.project(p).value());
    }
    return out;
  }
  /// The pose for features that are drawn as a pose has them, known by the labels given.
  [[nodiscard]] rig::Pose over(const std::vector<std::string>& drawn, const rig::Pose& pose,
                               std::vector<LineRead>& labels) const {
    Drawing drawing;
    drawing.in_view = true;
    for (const std::string& name : drawn) drawing.lines.push_back(line(curve(name), pose));
    DrawingRead reading;
    reading.lines = labels;
    reading.shares = {1.0};
    std::vector<std::size_t> free(model.rig->parameters().size());
    std::iota(free.begin(), free.end(), std::size_t{0});
    rig::Pose found = pose_over_face(*model.rig, whole, curves, drawing, reading, camera, rest, free).value();
    labels = reading.lines;
    return found;
  }
};

LineRead labelled(std::size_t curve) {
  LineRead line;
  line.curve = curve;
  return line;
}

TEST(PoseOverFace, AFeatureGoesWhereItsLineWasDrawn) {
  const Head head;
  rig::Pose smile = head.rest;
  smile[head.control("mouth_corner_L")] = smile[head.control("mouth_corner_R")] = 0.7;
  std::vector<LineRead> labels{labelled(head.curve("lip_upper_inner")), labelled(head.curve("lip_lower_inner"))};
  const rig::Pose found = head.over({"lip_upper_inner", "lip_lower_inner"}, smile, labels);
  EXPECT_NEAR(found[head.control("mouth_corner_L")], 0.7, 0.15);
  EXPECT_NEAR(found[head.control("mouth_corner_R")], 0.7, 0.15);
}

TEST(PoseOverFace, ALidThatIsDrawnAloneIsTheUpperOne) {
  const Head head;
  rig::Pose wink = head.rest;
  wink[head.control("eyelid_upper_L")] = 1;
  std::vector<LineRead> labels{labelled(head.curve("eyelid_lower_L"))};
  const rig::Pose found = head.over({"eyelid_upper_L"}, wink, labels);
  EXPECT_EQ(labels[0].curve, head.curve("eyelid_upper_L"));
  EXPECT_GT(found[head.control("eyelid_upper_L")], 0.7);
}

TEST(PoseOverFace, BothLipsAreDrawnAlongTheSameBorder) {
  const Head head;
  rig::Pose open = head.rest;
  open[head.control("jaw")] = 0.6;
  std::vector<LineRead> labels{labelled(head.curve("lip_upper")), labelled(head.curve("lip_lower_inner"))};
  const rig::Pose found = head.over({"lip_upper_inner", "lip_lower_inner"}, open, labels);
  EXPECT_EQ(labels[0].curve, head.curve("lip_upper_inner"));
  EXPECT_NEAR(found[head.control("jaw")], 0.6, 0.2);
}

TEST(PoseOverFace, LinesWithoutALabelOrAFeatureMoveNothing) {
  const Head head;
  std::vector<LineRead> none{LineRead{}};
  EXPECT_EQ(head.over({"jaw"}, head.rest, none), head.rest);
}

TEST(PoseOverFace, OneLineAlongShutLipsMovesBoth) {
  const Head head;
  rig::Pose smile = head.rest;
  smile[head.control("mouth_corner_L")] = smile[head.control("mouth_corner_R")] = 0.7;
  for (const char* taken_for : {"lip_lower_inner", "lip_upper_inner"}) {
    std::vector<LineRead> labels{labelled(head.curve(taken_for))};
    const rig::Pose found = head.over({"lip_upper_inner"}, smile, labels);
    EXPECT_EQ(labels[0].curve, head.curve("lip_upper_inner")) << taken_for;
    EXPECT_NEAR(found[head.control("mouth_corner_L")], 0.7, 0.15) << taken_for;
    EXPECT_NEAR(found[head.control("mouth_corner_R")], 0.7, 0.15) << taken_for;
  }
}

TEST(PoseOverFace, ALowerLipDrawnFarDownIsNoShutMouth) {
  const Head head;
  rig::Pose open = head.rest;
  open[head.control("jaw")] = 0.8;
  std::vector<LineRead> labels{labelled(head.curve("lip_lower_inner"))};
  const rig::Pose found = head.over({"lip_lower_inner"}, open, labels);
  EXPECT_EQ(labels[0].curve, head.curve("lip_lower_inner"));
  EXPECT_GT(found[head.control("jaw")], 0.5);
}

TEST(PoseOverFace, ALineThatABrowMeetsIsNoLid) {
  const Head head;
  rig::Pose raised = head.rest;
  raised[head.control("brow_inner_L")] = raised[head.control("brow_outer_L")] = 0.8;
  std::vector<LineRead> labels{labelled(head.curve("eyelid_upper_L"))};
  const rig::Pose found = head.over({"brow_L"}, raised, labels);
  EXPECT_EQ(labels[0].curve, head.curve("brow_L"));
  EXPECT_GT(found[head.control("brow_inner_L")], 0.4);
}

}  // namespace
}  // namespace penpose::portrait
