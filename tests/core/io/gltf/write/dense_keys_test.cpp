#include "core/io/gltf/write/dense_keys.h"

#include <cmath>
#include <gtest/gtest.h>

#include "tests/support/models/test_rigs.h"

namespace penpose::io {
namespace {

document::Model lifted() {
  const auto mesh = tests::grid_mesh(2, 2);
  rig::BlendShape shape;
  shape.parameter = {"lift", 0, 0, 1};
  shape.vertices = {4};
  shape.deltas.emplace_back(0.0F, 0.25F, 1.0F);
  return document::make_model(mesh, rig::BlendShapes::make({shape}, mesh->vertex_count()).value(), nullptr).value();
}

/// A spline from 0 to 1 and back, eased at its keys.
document::Channel eased(std::vector<double> times_s) {
  document::Channel channel;
  channel.interpolation = document::Interpolation::cubic_spline;
  for (std::size_t k = 0; k < times_s.size(); ++k) {
    const double value = k % 2 == 0 ? 0 : 1;
    channel.values.insert(channel.values.end(), {0, value, 0});
  }
  channel.times_s = std::move(times_s);
  return channel;
}

TEST(DenseKeys, ASplineWithKeysOnFramesGetsItsOthersOnFrames) {
  const auto model = lifted();
  const GlbTargets targets(model, 1e-4);
  const auto keys = dense_keys(eased({0, 6.0 / 24, 14.0 / 24}), targets, 1e-4);
  EXPECT_TRUE(keys.straightened);
  ASSERT_LE(keys.times_s.size(), 15U);
  EXPECT_GT(keys.times_s.size(), 8U);
  for (std::size_t k = 0; k < keys.times_s.size(); ++k) {
    const double frame = 24.0 * static_cast<double>(keys.times_s[k]);
    EXPECT_NEAR(frame, std::round(frame), 1e-4);
    // 3 t^2 - 2 t^3, the ease between two keys.
    const double t = frame <= 6 ? frame / 6 : (frame - 6) / 8;
    const double ease = t * t * (3 - 2 * t);
    EXPECT_NEAR(keys.rows[k][0], frame <= 6 ? ease : 1 - ease, 1e-5) << frame;
  }
  EXPECT_GT(keys.error, 0) << "between frames it is said to be straight";
}

TEST(DenseKeys, KeysOffFramesAreFollowedAsNearAsTheToleranceAsks) {
  const auto model = lifted();
  const GlbTargets targets(model, 1e-4);
  const auto keys = dense_keys(eased({0, 0.2513, 0.6131}), targets, 1e-3);
  EXPECT_LE(keys.error, 1e-3);
}

}  // namespace
}  // namespace penpose::io
