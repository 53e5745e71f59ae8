#include "core/articulation/region/canvas.h"

#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include "core/articulation/deformer.h"
#include "core/articulation/sketched_deformers.h"
#include "core/geometry/rotation.h"
#include "core/rig/character_rig.h"
#include "tests/support/models/articulation_models.h"

namespace penpose::articulation {
namespace {

/// A skeleton of one joint (turned, scaled, moved) that carries all vertices of a mesh, with its inverse bind taking
/// rest vertices half the way.
std::shared_ptr<const rig::Skeleton> one_joint(std::size_t vertices, const glm::dvec3& scale) {
  rig::Joint joint;
  joint.name = "head";
  joint.translation = {5, -3, 2};
  joint.rest_rotation = geometry::quaternion_from_xyz({0.4, -1.1, 2.0});
  joint.scale = scale;
  joint.inverse_bind = geometry::compose({0.1, 0.2, 0.3}, geometry::quaternion_from_xyz({0, 0.3, 0}), {1, 1, 1});
  std::vector<std::uint32_t> first;
  std::vector<rig::Influence> influences(vertices, rig::Influence{0, 1.0});
  for (std::uint32_t v = 0; v <= vertices; ++v) first.push_back(v);
  return rig::Skeleton::make({joint}, first, influences).value();
}

/// The trunk's mesh moved away so that the joint shows it where the plain trunk is.
mesh::MeshSource carried_back(const Canvas& plain, const rig::Skeleton& skeleton) {
  std::vector<glm::dmat4> matrices(1);
  skeleton.joint_matrices(std::vector<double>(3, 0.0), matrices);
  const glm::dmat4 back = glm::inverse(matrices[0]);
  mesh::MeshSource source;
  for (const ModelPoint& p : plain.positions()) source.positions.emplace_back(back * glm::dvec4(p, 1));
  source.triangles.assign(plain.mesh().triangles().begin(), plain.mesh().triangles().end());
  return source;
}

TEST(Canvas, ShowsACarriedMeshWhereItsJointsCarryItAndMovesItAsSeen) {
  const tests::Trunk trunk = tests::make_trunk();
  const auto skeleton = one_joint(trunk.canvas->positions().size(), {2, 2, 2});
  const auto mesh = mesh::TriangleMesh::build(carried_back(*trunk.canvas, *skeleton)).value();
  const auto canvas = Canvas::make(mesh, skeleton.get()).value();
  for (std::size_t v = 0; v < canvas->positions().size(); v += 37) {
    EXPECT_LT(geometry::distance(canvas->positions()[v], trunk.canvas->positions()[v]), 1e-5);
  }
  // The deformer acts before the joint and is seen to do what it does on the plain mesh.
  const auto plain = SketchedDeformers::build(std::vector{trunk.curl()}, *trunk.canvas).value();
  const auto carried = SketchedDeformers::build(std::vector{trunk.curl()}, *canvas).value();
  const auto plain_rig = rig::CharacterRig::make(
      mesh::TriangleMesh::build({{trunk.canvas->positions().begin(), trunk.canvas->positions().end()},
                                 {},
                                 {mesh->triangles().begin(), mesh->triangles().end()},
                                 {}})
          .value(),
      {plain}, nullptr);
  const auto carried_rig = rig::CharacterRig::make(mesh, {carried}, skeleton);
  std::vector<ModelPoint> a(mesh->vertex_count());
  std::vector<ModelPoint> b(mesh->vertex_count());
  (*plain_rig)->evaluate(std::vector<double>{0.7}, a);
  (*carried_rig)->evaluate(std::vector<double>{0.7, 0, 0, 0}, b);
  double moved = 0;
  for (std::size_t v = 0; v < a.size(); ++v) {
    EXPECT_LT(geometry::distance(a[v], b[v]), 1e-4);
    moved = std::max(moved, geometry::distance(a[v], trunk.canvas->positions()[v]));
  }
  EXPECT_GT(moved, 1.0);
}

TEST(Canvas, SaysWhichVertexItsJointsFlatten) {
  const tests::Trunk trunk = tests::make_trunk();
  const auto skeleton = one_joint(trunk.canvas->positions().size(), {2, 0, 2});
  const auto canvas =
      Canvas::make(trunk.canvas->mesh().vertex_count() > 0
                       ? mesh::TriangleMesh::build(
                             {{trunk.canvas->positions().begin(), trunk.canvas->positions().end()},
                              {},
                              {trunk.canvas->mesh().triangles().begin(), trunk.canvas->mesh().triangles().end()},
                              {}})
                             .value()
                       : nullptr,
                   skeleton.get())
          .value();
  const auto flat = canvas->to_rest(3);
  ASSERT_FALSE(flat.ok());
  EXPECT_EQ(flat.error().place, "vertex 3");
}

TEST(Canvas, RefusesTheSkeletonOfAnotherMesh) {
  const tests::Trunk trunk = tests::make_trunk();
  const auto skeleton = one_joint(7, {1, 1, 1});
  const auto mesh = mesh::TriangleMesh::build({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}, {{0, 1, 2}}, {}}).value();
  EXPECT_FALSE(Canvas::make(mesh, skeleton.get()).ok());
}

}  // namespace
}  // namespace penpose::articulation
