#include "core/io/gltf/write/one_way_targets.h"

#include <gtest/gtest.h>

#include "core/document/time/animation_building.h"
#include "core/document/time/animation_sampling.h"
#include "core/io/model/read_model.h"
#include "core/io/model/write_model.h"
#include "tests/support/models/test_rigs.h"

namespace penpose::io {
namespace {

/// A grid with one shape of a wide range, animated through it.
document::Model swinging() {
  const auto mesh = tests::grid_mesh(2, 2);
  rig::BlendShape shape;
  shape.parameter = {"lift", 0, -2, 3};
  shape.vertices = {4};
  shape.deltas.emplace_back(0.0F, 0.25F, 1.0F);
  const auto shapes = rig::BlendShapes::make({shape}, mesh->vertex_count()).value();
  auto model = document::make_model(mesh, shapes, nullptr).value();
  const std::vector<double> times{0, 0.5, 1, 1.5};
  const std::vector<rig::Pose> poses{{0.5}, {-1.5}, {2.5}, {-0.25}};
  model.animations = {document::make_animation(model, "swing", times, poses)};
  model.pose = {-0.25};
  return model;
}

TEST(OneWayTargets, EveryPartOfAWeightIsWithinZeroAndOne) {
  const auto model = swinging();
  const std::vector<const rig::BlendShape*> targets{&model.shapes->shapes()[0]};
  const std::vector<double> low{-1.5};
  const std::vector<double> high{2.5};
  const auto parts = one_way_targets(targets, low, high);
  ASSERT_EQ(parts.size(), 4U);
  for (const double weight : {-1.5, -0.25, 0.0, 0.5, 1.25, 2.5}) {
    double sum = std::min(1.0, std::max(0.0, weight));
    for (const OneWayTarget& one : parts) {
      EXPECT_GE(one.part(weight), 0);
      EXPECT_LE(one.part(weight), 1);
      sum += (one.turned ? -1 : 1) * one.part(weight);
    }
    EXPECT_EQ(sum, weight);
  }
}

TEST(OneWayTargets, AFileReadsBackAsItWasAndShowsNoWeightOutsideZeroAndOne) {
  const auto model = swinging();
  const auto bytes = write_glb(model).value();
  const auto back = read_model(bytes, "swing.glb").value();
  ASSERT_EQ(back.rig->parameters().size(), 1U);
  EXPECT_EQ(back.rig->parameters()[0].name, "lift");
  EXPECT_EQ(back.pose[0], -0.25);
  for (int k = 0; k <= 30; ++k) {
    const double t = 0.05 * k;
    const auto a = document::model_at(model, document::sample(model, model.animations[0], t)).value().pose[0];
    const auto b = document::model_at(back, document::sample(back, back.animations[0], t)).value().pose[0];
    EXPECT_NEAR(a, b, 1e-6) << t;
  }
  const std::string text(bytes.begin(), bytes.end());
  EXPECT_NE(text.find("lift~turned"), std::string::npos);
  EXPECT_NE(text.find("lift~more2"), std::string::npos);
  EXPECT_NE(text.find("\"fps\""), std::string::npos);
}

TEST(OneWayTargets, WeightsWithinZeroAndOneNeedNone) {
  auto model = swinging();
  model.animations.clear();
  model.pose = {0.5};
  const auto bytes = write_glb(model).value();
  EXPECT_EQ(std::string(bytes.begin(), bytes.end()).find("lift~"), std::string::npos);
}

}  // namespace
}  // namespace penpose::io
