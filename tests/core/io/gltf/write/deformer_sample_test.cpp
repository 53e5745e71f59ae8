#include "core/io/gltf/write/deformer_sample.h"

#include <gtest/gtest.h>

#include "tests/support/models/articulation_models.h"

namespace penpose::io {
namespace {

TEST(DeformerSample, IsWhatTheDeformerDoesAtOne) {
  const tests::Trunk trunk = tests::make_trunk();
  const auto deformer = articulation::build_deformer(trunk.curl(), *trunk.canvas).value();
  rig::BlendShape shape = sample_deformer(*deformer);
  EXPECT_EQ(shape.parameter, deformer->parameter());
  const std::vector<geometry::ModelVector> moves = deformer->displacements(1.0);
  for (std::size_t i = 0; i < moves.size(); ++i) EXPECT_EQ(shape.deltas[i], glm::vec3(moves[i]));

  EXPECT_TRUE(is_sample_of(shape, *deformer, 0.0));
  // A file may leave out a vertex that hardly moves, or round.
  std::size_t least = 0;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    if (geometry::length(moves[i]) < geometry::length(moves[least])) least = i;
  }
  rig::BlendShape thinned = shape;
  thinned.vertices.erase(thinned.vertices.begin() + static_cast<std::ptrdiff_t>(least));
  thinned.deltas.erase(thinned.deltas.begin() + static_cast<std::ptrdiff_t>(least));
  EXPECT_TRUE(is_sample_of(thinned, *deformer, geometry::length(moves[least]) + 1e-6));
  shape.deltas[7] += glm::vec3(0, 0.01, 0);
  EXPECT_FALSE(is_sample_of(shape, *deformer, 0.001));
}

}  // namespace
}  // namespace penpose::io
