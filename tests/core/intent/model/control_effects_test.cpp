#include "core/intent/model/control_effects.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/intent/model/mirror_pairs.h"
#include "tests/support/models/joint_trees.h"

namespace penpose::intent {
namespace {

/// A rig of which nothing is known but where it takes its vertices.
class Unknown final : public rig::Rig {
 public:
  explicit Unknown(const rig::Rig& rig) : rig_(rig) {}
  [[nodiscard]] std::span<const rig::Parameter> parameters() const override { return rig_.parameters(); }
  [[nodiscard]] std::size_t vertex_count() const override { return rig_.vertex_count(); }
  void evaluate(std::span<const double> pose, std::span<ModelPoint> positions) const override {
    rig_.evaluate(pose, positions);
  }
  [[nodiscard]] std::unique_ptr<rig::BoundVertices> bind(std::span<const std::uint32_t> vertices) const override {
    return rig_.bind(vertices);
  }

 private:
  const rig::Rig& rig_;
};

/// All vertices after an effect.
std::vector<ModelPoint> after(const ControlEffects& effects, const ControlEffect& effect) {
  std::vector<ModelPoint> all(effects.rest().begin(), effects.rest().end());
  for (std::size_t k = 0; k < effect.vertices.size(); ++k) {
    EXPECT_EQ(effect.rest[k], all[effect.vertices[k]]);
    all[effect.vertices[k]] = effect.moved[k];
  }
  return all;
}

void expect_equal_effects(const rig::CharacterRig& rig) {
  const Unknown unknown(rig);
  ControlEffects known_effects(rig);
  ControlEffects whole_effects(unknown);
  std::size_t few = 0;
  for (std::size_t p = 0; p < rig.parameters().size(); ++p) {
    const ControlEffect known = known_effects.of(p, 0.25);
    const ControlEffect whole = whole_effects.of(p, 0.25);
    EXPECT_EQ(whole.vertices.size(), rig.vertex_count());
    few += known.vertices.size() < rig.vertex_count();
    EXPECT_EQ(after(known_effects, known), after(whole_effects, whole)) << rig.parameters()[p].name;
    const ControlMoments a = moments_of(known.rest, known.moved);
    const ControlMoments b = moments_of(whole.rest, whole.moved);
    EXPECT_EQ(a.way, b.way);
    EXPECT_EQ(a.centre, b.centre);
    EXPECT_EQ(a.direction, b.direction);
    EXPECT_EQ(a.radius, b.radius);
  }
  EXPECT_GT(few, rig.parameters().size() / 2);
}

TEST(ControlEffects, OfJointsAreThoseOnTheWholeModelBitForBit) {
  const auto mesh = tests::grid_mesh(20, 15, 3, 1);
  const auto shapes = tests::random_shapes(*mesh, 3, 8);
  for (const auto& skeleton : {tests::chain_skeleton(*mesh, 40, 0.07, 0.1), tests::bushy_skeleton(*mesh, 60, 3)})
    expect_equal_effects(*rig::CharacterRig::make(mesh, {shapes}, skeleton).value());
}

TEST(ControlEffects, AVertexThatIsNoNumberIsInEveryEffect) {
  const auto mesh = tests::grid_mesh(20, 15, 3, 1);
  const auto good = tests::chain_skeleton(*mesh, 4, 1);
  std::vector<rig::Joint> joints(good->joints().begin(), good->joints().end());
  joints[3].translation.x = 1e200;
  joints[3].inverse_bind[3][0] = 1e200;
  joints[3].scale.x = 1e200;
  std::vector<std::uint32_t> first{0};
  std::vector<rig::Influence> influences;
  for (std::uint32_t v = 0; v < mesh->vertex_count(); ++v) {
    for (const rig::Influence& influence : good->influences_of(v)) influences.push_back(influence);
    first.push_back(static_cast<std::uint32_t>(influences.size()));
  }
  const auto skeleton = rig::Skeleton::make(joints, first, influences).value();
  const auto rig = rig::CharacterRig::make(mesh, {}, skeleton).value();
  ControlEffects effects(*rig);
  EXPECT_FALSE(std::isfinite(effects.rest().back().x));
  EXPECT_EQ(effects.of(0, 0.25).vertices.size(), rig->vertex_count());
}

}  // namespace
}  // namespace penpose::intent
