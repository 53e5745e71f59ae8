#include "core/rig/character_rig.h"

#include <cmath>
#include <gtest/gtest.h>

#include "tests/support/models/test_rigs.h"

namespace penpose::rig {
namespace {

/// Displaces every vertex along z by the sine of its parameter: a layer that is not linear.
class Wave final : public DisplacementLayer {
 public:
  explicit Wave(std::string name) : parameters_{{std::move(name), 0, -1, 1}} {}
  [[nodiscard]] std::span<const Parameter> parameters() const override { return parameters_; }
  void add(std::span<const double> values, std::span<ModelVector> displacements) const override {
    for (ModelVector& d : displacements) d.z += std::sin(values[0]);
  }
  [[nodiscard]] std::unique_ptr<BoundLayer> bind(std::span<const std::uint32_t>) const override {
    return std::make_unique<Bound>(*this);
  }

 private:
  class Bound final : public BoundLayer {
   public:
    explicit Bound(const Wave& wave) : wave_(wave) {}
    void add(std::span<const double> values, std::span<ModelVector> displacements) override {
      wave_.add(values, displacements);
    }
    [[nodiscard]] bool moves(std::size_t) const override { return true; }
    bool column(std::size_t, std::span<ModelVector>) const override { return false; }

   private:
    const Wave& wave_;
  };
  std::vector<Parameter> parameters_;
};

struct Character {
  std::shared_ptr<const mesh::TriangleMesh> mesh = tests::grid_mesh(12, 4, 3, 1);
  std::shared_ptr<const BlendShapes> shapes = tests::random_shapes(*mesh, 9, 5);
  std::shared_ptr<const Skeleton> skeleton = tests::chain_skeleton(*mesh, 4, 1, 0.3);
  std::shared_ptr<const CharacterRig> rig = CharacterRig::make(mesh, {shapes}, skeleton).value();
  std::vector<std::uint32_t> some{0, 3, 17, 17, 40, 64};
};

TEST(CharacterRig, SumsShapesAndThenCarriesThemByTheJoints) {
  const Character c;
  tests::Random random(2);
  const Pose pose = tests::random_pose(*c.rig, random);
  const auto got = tests::all_positions(*c.rig, pose);
  std::vector<ModelVector> displaced(c.mesh->vertex_count(), ModelVector{0});
  c.shapes->add(std::span(pose).first(9), displaced);
  std::vector<glm::dmat4> matrices(4);
  c.skeleton->joint_matrices(std::span(pose).subspan(9), matrices);
  for (std::uint32_t v = 0; v < got.size(); ++v) {
    const glm::dvec4 rest(c.mesh->positions()[v] + displaced[v], 1);
    ModelPoint blended{0};
    for (const Influence& i : c.skeleton->influences_of(v)) blended += ModelPoint(matrices[i.joint] * rest) * i.weight;
    EXPECT_NEAR(geometry::distance(got[v], blended), 0, 1e-12);
  }
}

TEST(CharacterRig, AddsTheDisplacementsOfAllLayers) {
  const auto mesh = tests::grid_mesh(6, 6);
  const auto one = tests::random_shapes(*mesh, 1, 1);
  const auto wave = std::make_shared<Wave>("wave");
  const auto rig = CharacterRig::make(mesh, {one, wave}, nullptr).value();
  EXPECT_EQ(rig->first_parameter(1), 1U);
  EXPECT_EQ(rig->parameters()[1].name, "wave");
  const Pose pose{0.5, 0.7};
  std::vector<ModelVector> sum(mesh->positions().begin(), mesh->positions().end());
  one->add(std::span(pose).first(1), sum);
  wave->add(std::span(pose).last(1), sum);
  const auto got = tests::all_positions(*rig, pose);
  for (std::size_t v = 0; v < got.size(); ++v) EXPECT_NEAR(geometry::distance(got[v], sum[v]), 0, 1e-15);
}

TEST(CharacterRig, BoundVerticesAreThoseOfTheWholeMeshBitForBit) {
  const Character c;
  tests::Random random(3);
  const auto bound = c.rig->bind(c.some);
  ASSERT_EQ(bound->vertex_count(), c.some.size());
  std::vector<ModelPoint> few(c.some.size());
  for (int i = 0; i < 20; ++i) {
    const Pose pose = tests::random_pose(*c.rig, random);
    bound->evaluate(pose, few);
    const auto all = tests::all_positions(*c.rig, pose);
    for (std::size_t k = 0; k < few.size(); ++k) EXPECT_EQ(few[k], all[c.some[k]]);
  }
}

TEST(CharacterRig, KnowsWhichParametersMoveTheBoundVertices) {
  const Character c;
  const std::vector<std::uint32_t> left{0, 13};  // x = 0: carried by the first joint alone
  const auto bound = c.rig->bind(left);
  std::vector<ModelPoint> rest(2);
  std::vector<ModelPoint> moved(2);
  for (std::size_t p = 0; p < c.rig->parameters().size(); ++p) {
    Pose pose = rest_pose(*c.rig);
    bound->evaluate(pose, rest);
    pose[p] = c.rig->parameters()[p].maximum;
    bound->evaluate(pose, moved);
    if (moved != rest) {
      EXPECT_TRUE(bound->moves(p)) << p;
    }
    if (p >= 12) {
      EXPECT_FALSE(bound->moves(p)) << "joint below the one that carries the vertices";
    }
  }
  EXPECT_TRUE(bound->moves(9));
  const std::vector<std::uint32_t> right{12};  // x = 3, the last joint, carried by all joints above
  const auto tip = c.rig->bind(right);
  for (std::size_t p = 9; p < 21; ++p) EXPECT_TRUE(tip->moves(p)) << p;
}

TEST(CharacterRig, TheLinearFormAgreesWithTheRigAlsoWithJointsPosed) {
  const Character c;
  tests::Random random(4);
  const std::size_t n = c.some.size();
  for (int run = 0; run < 20; ++run) {
    Pose pose = tests::random_pose(*c.rig, random);
    const std::vector<std::size_t> free{1, 2, 5, 8};
    const auto form = c.rig->bind(c.some)->linearize(pose, free);
    ASSERT_TRUE(form);
    ASSERT_EQ(form->constant.size(), n);
    ASSERT_EQ(form->columns.size(), n * free.size());
    for (const std::size_t p : free) pose[p] = random(0, 1);
    const auto all = tests::all_positions(*c.rig, pose);
    for (std::size_t k = 0; k < n; ++k) {
      ModelPoint at = form->constant[k];
      for (std::size_t i = 0; i < free.size(); ++i) at += form->columns[i * n + k] * pose[free[i]];
      EXPECT_NEAR(geometry::distance(at, all[c.some[k]]), 0, 1e-12);
    }
  }
}

TEST(CharacterRig, HasNoLinearFormInJointsThatMoveTheVertices) {
  const Character c;
  const Pose rest = rest_pose(*c.rig);
  EXPECT_FALSE(c.rig->bind(c.some)->linearize(rest, std::vector<std::size_t>{2, 9}));
  // The last joint is free, but carries none of these vertices: it does not stand in the way.
  const std::vector<std::uint32_t> left{0, 13};
  const auto form = c.rig->bind(left)->linearize(rest, std::vector<std::size_t>{2, 20});
  ASSERT_TRUE(form);
  EXPECT_EQ(form->columns[2], (ModelVector{0, 0, 0}));
  EXPECT_EQ(form->columns[3], (ModelVector{0, 0, 0}));
}

TEST(CharacterRig, HasNoLinearFormInALayerThatIsNotLinear) {
  const auto mesh = tests::grid_mesh(2, 2);
  const auto rig =
      CharacterRig::make(mesh, {tests::random_shapes(*mesh, 2, 1), std::make_shared<Wave>("wave")}, nullptr).value();
  const auto bound = rig->bind(std::vector<std::uint32_t>{0, 1});
  EXPECT_FALSE(bound->linearize(rest_pose(*rig), std::vector<std::size_t>{0, 2}));
  const auto form = bound->linearize(Pose{0.1, 0.2, 0.5}, std::vector<std::size_t>{0, 1});
  ASSERT_TRUE(form) << "it stands still here";
  EXPECT_NEAR(form->constant[0].z, std::sin(0.5), 1e-12);
}

TEST(CharacterRig, RefusesWhatDoesNotFitTogether) {
  const auto mesh = tests::grid_mesh(3, 3);
  const auto other = tests::grid_mesh(4, 4);
  const auto shapes = tests::random_shapes(*mesh, 2, 1);
  EXPECT_FALSE(CharacterRig::make(mesh, {shapes}, tests::chain_skeleton(*other, 2, 1)));
  const auto twice = CharacterRig::make(mesh, {shapes, tests::random_shapes(*mesh, 1, 2)}, nullptr);
  ASSERT_FALSE(twice);
  EXPECT_EQ(twice.error().place, "parameter shape0");
}

TEST(CharacterRig, WithoutLayersAndJointsItIsTheMesh) {
  const auto mesh = tests::grid_mesh(3, 3);
  const auto rig = CharacterRig::make(mesh, {}, nullptr).value();
  EXPECT_TRUE(rig->parameters().empty());
  const auto positions = tests::all_positions(*rig, {});
  for (std::size_t v = 0; v < positions.size(); ++v) EXPECT_EQ(positions[v], mesh->positions()[v]);
}

}  // namespace
}  // namespace penpose::rig
