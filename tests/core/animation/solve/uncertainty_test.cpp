#include "core/animation/solve/uncertainty.h"

#include <cmath>
#include <gtest/gtest.h>

#include "tests/support/models/test_rigs.h"

namespace penpose::animation {
namespace {

constexpr double k_prior = 16;  // one over the square of a quarter of the range

/// Four points in a row, `shapes` shapes that raise all of them by 0.1 units, and a parameter that moves none.
class ParameterUncertainty : public testing::Test {
 protected:
  Uncertainty doubts(std::size_t shapes, double deviation_px, double weight = 1) {
    const auto mesh = tests::grid_mesh(3, 1);
    std::vector<rig::BlendShape> all;
    for (std::size_t s = 0; s <= shapes; ++s) {
      rig::BlendShape shape;
      shape.parameter.name = "shape" + std::to_string(s);
      for (std::uint32_t v = 0; v < 4; ++v) {
        shape.vertices.push_back(s < shapes ? v : v + 4);
        shape.deltas.emplace_back(0, 0.1F, 0);
      }
      all.push_back(std::move(shape));
    }
    const auto rig =
        rig::CharacterRig::make(mesh, {rig::BlendShapes::make(all, mesh->vertex_count()).value()}, nullptr).value();
    Transfer transfer;
    for (std::uint32_t v = 0; v < 4; ++v) {
      transfer.points.push_back(posing::at_vertex(v));
      transfer.weights.push_back(weight);
      transfer.scale.push_back(2);
    }
    std::vector<std::size_t> searched(shapes + 1);
    for (std::size_t s = 0; s <= shapes; ++s) searched[s] = s;
    const std::vector<double> rest(shapes + 1, 0.0);
    return parameter_uncertainty(*rig, rest, searched, transfer, camera_, deviation_px);
  }
  /// What four points tell of a parameter: the square of the way in deviations, summed.
  [[nodiscard]] double told(double deviation_px) const {
    const double way = 0.1 / camera_.units_per_px(camera_.depth({0, 0, 0}));
    return 4 * (way / (2 * deviation_px)) * (way / (2 * deviation_px));
  }

  geometry::Camera camera_ = geometry::frame_box({{0, 0, 0}, {1, 1, 0}}, {500, 500}, 0);
};

TEST_F(ParameterUncertainty, OfOneParameterIsThatOfTheMeanOfItsPoints) {
  for (const double deviation : {0.5, 3.0}) {
    const auto found = doubts(1, deviation);
    EXPECT_NEAR(found.parameters[0], 1 / std::sqrt(told(deviation) + k_prior), 1e-6);
    EXPECT_NEAR(found.parameters[1], 0.25, 1e-12);  // nothing is told of what moves no point
  }
  EXPECT_NEAR(doubts(1, 1, 4).parameters[0], 1 / std::sqrt(4 * told(1) + k_prior), 1e-6);
}

TEST_F(ParameterUncertainty, ParametersThatDoTheSameAreInMoreDoubt) {
  // The inverse of [[t + p, t], [t, t + p]].
  const double t = told(1);
  const auto found = doubts(2, 1);
  EXPECT_NEAR(found.parameters[0], std::sqrt((t + k_prior) / (k_prior * (2 * t + k_prior))), 1e-6);
  EXPECT_NEAR(found.parameters[1], found.parameters[0], 1e-12);
  EXPECT_NEAR(found.deviations[0], 1 / std::sqrt(2 * t + k_prior), 1e-6);  // not so what they do together
  EXPECT_NEAR(found.directions[0], found.directions[1], 1e-6);
  EXPECT_GT(found.parameters[0], 3 * doubts(1, 1).parameters[0]);
}

}  // namespace
}  // namespace penpose::animation
