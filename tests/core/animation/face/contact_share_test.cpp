#include "core/animation/face/contact_share.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "core/animation/animate_track.h"
#include "tests/support/models/rendered_track.h"
#include "tests/support/models/test_rigs.h"

namespace penpose::animation {
namespace {

constexpr std::uint32_t k_columns = 10;

/// Two rows of vertices one unit apart, an eye. "close" lowers the upper row onto the lower one, "raise", where it is
/// asked for, raises the lower row as far.
std::shared_ptr<const rig::CharacterRig> eye_rig(bool with_raise) {
  const auto mesh = tests::grid_mesh(k_columns, 1, 2, 1);
  rig::BlendShape close;
  rig::BlendShape raise;
  close.parameter.name = "close";
  raise.parameter.name = "raise";
  for (std::uint32_t i = 0; i <= k_columns; ++i) {
    raise.vertices.push_back(i);
    raise.deltas.emplace_back(0, 1, 0);
    close.vertices.push_back(k_columns + 1 + i);
    close.deltas.emplace_back(0, -1, 0);
  }
  std::vector<rig::BlendShape> shapes{close};
  if (with_raise) shapes.push_back(raise);
  return rig::CharacterRig::make(mesh, {rig::BlendShapes::make(shapes, mesh->vertex_count()).value()}, nullptr).value();
}

class ContactShare : public testing::Test {
 protected:
  /// An eye of which both lids go 0.3 towards the middle in the last frame, seen by a tracker.
  void see(bool with_raise, bool lower_backwards) {
    rig_ = eye_rig(with_raise);
    std::vector<std::uint32_t> vertices;
    TrackedCurve upper;
    TrackedCurve lower;
    for (std::uint32_t i = 0; i <= k_columns; ++i) {
      upper.points.push_back(i);
      lower.points.push_back(k_columns + 1 + i);
      upper.reference.push_back(posing::at_vertex(k_columns + 1 + i));
      lower.reference.push_back(posing::at_vertex(i));
    }
    for (std::uint32_t i = 0; i <= k_columns; ++i) vertices.push_back(k_columns + 1 + i);
    for (std::uint32_t i = 0; i <= k_columns; ++i) vertices.push_back(i);
    if (lower_backwards) std::reverse(lower.points.begin(), lower.points.end());
    upper.meets = 1;
    lower.meets = 0;
    setup_.curves = {upper, lower};
    setup_.rest = rig::rest_pose(*rig_);
    setup_.free.clear();
    for (std::size_t p = 0; p < setup_.rest.size(); ++p) setup_.free.push_back(p);
    setup_.tremor_px = 0;
    track_ = tests::track_of(*rig_, std::vector<rig::Pose>(30, setup_.rest), vertices, camera_);
    const double px = 0.3 / camera_.units_per_px(camera_.depth({1, 0.5, 0}));
    for (std::size_t i = 0; i < 2 * (k_columns + 1); ++i) {
      for (std::size_t f = 10; f < 30; ++f) track_.frames[f].points[i].y += i <= k_columns ? px : -px;
    }
  }
  rig::Pose last() { return animate_track(*rig_, track_, setup_, camera_).value().poses.back(); }

  std::shared_ptr<const rig::CharacterRig> rig_;
  geometry::Camera camera_ = geometry::frame_box({{-0.5, -0.5, 0}, {2.5, 1.5, 0}}, {500, 500}, 0);
  TrackSetup setup_;
  PointTrack track_;
};

TEST_F(ContactShare, ALidThatMovesAloneClosesTheEyeAsFarAsBothLidsOfTheFace) {
  for (const bool backwards : {false, true}) {
    see(false, backwards);
    EXPECT_NEAR(last()[0], 0.6, 0.03) << backwards;
  }
}

TEST_F(ContactShare, WhereBothLidsMoveEachFollowsItsOwn) {
  see(true, false);
  const auto pose = last();
  EXPECT_NEAR(pose[0], 0.3, 0.03);
  EXPECT_NEAR(pose[1], 0.3, 0.03);
}

TEST_F(ContactShare, CurvesThatMeetNothingAreLeftAsTheyWere) {
  see(false, false);
  for (TrackedCurve& curve : setup_.curves) curve.meets.reset();
  EXPECT_NEAR(last()[0], 0.3, 0.03);
}

}  // namespace
}  // namespace penpose::animation
