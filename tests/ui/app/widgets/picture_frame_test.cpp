#include "ui/app/widgets/picture_frame.h"

#include <cmath>
#include <gtest/gtest.h>

#include "ui/files/load_model.h"

namespace penpose::app {
namespace {

const PictureFrame& of(const PictureFrames& frames, FacePart part) { return frames[static_cast<std::size_t>(part)]; }

/// The places of the model's own curves at rest whose names begin so.
std::vector<geometry::ModelPoint> points_of(const document::Model& model, const std::string& begins) {
  std::vector<geometry::ModelPoint> rest(model.rig->vertex_count());
  model.rig->evaluate(rig::rest_pose(*model.rig), rest);
  std::vector<geometry::ModelPoint> out;
  for (const auto& curve : model.curves) {
    if (!curve.name.starts_with(begins)) continue;
    for (const auto& point : curve.points) out.push_back(rest[model.mesh->triangles()[point.triangle][0]]);
  }
  EXPECT_FALSE(out.empty()) << begins;
  return out;
}

bool holds_all(const PictureFrame& frame, const std::vector<geometry::ModelPoint>& points) {
  for (const auto& p : points) {
    if (std::abs(p.x - frame.middle.x) > 0.46 * frame.side || std::abs(p.y - frame.middle.y) > 0.46 * frame.side)
      return false;
  }
  return true;
}

TEST(PictureFrame, APictureOfAPartShowsThatPartAndNotTheOthers) {
  const auto model = files::load_model("builtin:demo");
  ASSERT_TRUE(model.ok());
  const PictureFrames frames = picture_frames(*model);
  const auto mouth = points_of(*model, "lip");
  const auto brows = points_of(*model, "brow");
  EXPECT_TRUE(holds_all(of(frames, FacePart::mouth), mouth));
  EXPECT_FALSE(holds_all(of(frames, FacePart::mouth), brows));
  EXPECT_TRUE(holds_all(of(frames, FacePart::brows), brows));
  EXPECT_FALSE(holds_all(of(frames, FacePart::brows), mouth));
  EXPECT_TRUE(holds_all(of(frames, FacePart::all), mouth)) << "the mouth was cut off once";
  EXPECT_TRUE(holds_all(of(frames, FacePart::all), brows));
  EXPECT_LT(of(frames, FacePart::mouth).side, of(frames, FacePart::all).side);
}

TEST(PictureFrame, AModelWithoutNamesOfAFaceIsShownWhole) {
  const auto model = files::load_model("builtin:head");
  ASSERT_TRUE(model.ok());
  ASSERT_EQ(model->rig->parameters().size(), 0U);
  const PictureFrames frames = picture_frames(*model);
  std::vector<geometry::ModelPoint> rest(model->rig->vertex_count());
  model->rig->evaluate(rig::rest_pose(*model->rig), rest);
  for (const auto& p : rest) {
    ASSERT_LE(std::abs(p.x - frames[0].middle.x), 0.5 * frames[0].side);
    ASSERT_LE(std::abs(p.y - frames[0].middle.y), 0.5 * frames[0].side);
  }
  EXPECT_EQ(of(frames, FacePart::eyes).side, frames[0].side);
}

}  // namespace
}  // namespace penpose::app
