#include "ui/render/cpu/cpu_renderer.h"

#include <gtest/gtest.h>

#include "core/character/demo_head.h"
#include "tests/support/models/render_shapes.h"

namespace penpose::render {
namespace {

/// The built-in head with some of its controls moved, drawn as the window draws it while something moves.
class MovingHead : public testing::Test {
 protected:
  MovingHead() { renderer_ = fresh(); }

  static std::unique_ptr<CpuRenderer> fresh() {
    auto made = std::make_unique<CpuRenderer>();
    made->set_occlusion(false);
    made->set_smoothing(true);
    return made;
  }
  /// Each pose has a number of its own.
  Image draw(CpuRenderer& renderer, double amount, bool clay = false) {
    document::Model posed_model = model_;
    posed_model.pose[0] = amount;
    const PosedMesh posed = posed_mesh(posed_model);
    Scene scene = scene_of(posed_model, posed, appearance_);
    scene.shape_number = 1;
    scene.pose_number = 1 + static_cast<std::uint64_t>(amount * 1000);
    scene.clay = clay;
    return renderer.render(scene, camera_).value();
  }

  document::Model model_ = character::make_demo_head().value();
  Appearance appearance_ = make_appearance(model_, {});
  geometry::Camera camera_ = frame_points(posed_mesh(model_).positions, {320, 240}, {10, 0});
  std::unique_ptr<CpuRenderer> renderer_;
};

TEST_F(MovingHead, WhatMovesIsDrawnAsIfAllOfItWere) {
  Image first = draw(*renderer_, 0);
  for (const double amount : {0.2, 0.7, 0.1, 0.0}) {
    const Image moved = draw(*renderer_, amount);
    EXPECT_EQ(moved, draw(*fresh(), amount)) << amount;
    if (amount > 0.1) {
      EXPECT_GT(differing(moved, first), 50) << amount;
    }
  }
}

TEST_F(MovingHead, WhereNothingMovesThePictureStaysSmooth) {
  Image smooth = draw(*renderer_, 0);
  const Image sharp = smooth;
  while (renderer_->refining()) smooth = draw(*renderer_, 0);
  const Image moved = draw(*renderer_, 0.5);
  // A shoulder is far from what moves.
  int same_as_smooth = 0;
  int same_as_sharp = 0;
  for (int x = 0; x < 320; ++x) {
    for (int y = 200; y < 240; ++y) {
      if (std::equal(smooth.at(x, y), smooth.at(x, y) + 4, sharp.at(x, y))) continue;
      same_as_smooth += std::equal(moved.at(x, y), moved.at(x, y) + 4, smooth.at(x, y)) ? 1 : 0;
      same_as_sharp += std::equal(moved.at(x, y), moved.at(x, y) + 4, sharp.at(x, y)) ? 1 : 0;
    }
  }
  EXPECT_GT(same_as_smooth, 30);
  EXPECT_EQ(same_as_sharp, 0);
}

TEST_F(MovingHead, ThreadsAndTheirNumberAreNotSeen) {
  for (int i = 0; i < 5; ++i) EXPECT_EQ(draw(*fresh(), 0.3), draw(*fresh(), 0.3));
}

}  // namespace
}  // namespace penpose::render
