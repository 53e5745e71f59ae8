#include "core/intent/model/contacts.h"

#include <gtest/gtest.h>

#include "core/intent/model/whole_model.h"
#include "core/intent/solve.h"
#include "tests/core/intent/face.h"

namespace penpose::intent {
namespace {

using geometry::ModelVector;

constexpr std::uint32_t k_columns = 21;
constexpr std::uint32_t k_rows = 11;

/// Two lips that touch along y = 0, x = -1 to 1: each goes from its front edge back to where they meet.
struct Lips {
  std::shared_ptr<const mesh::TriangleMesh> mesh;
  std::vector<rig::BlendShape> shapes;
  std::shared_ptr<const rig::CharacterRig> rig;

  Lips() {
    mesh::MeshSource source;
    for (const double side : {1.0, -1.0}) {
      const auto first = static_cast<std::uint32_t>(source.positions.size());
      for (std::uint32_t r = 0; r < k_rows; ++r) {
        // From the front of the lip, across its edge, to the inside of the mouth.
        const double turn = 3.14159265358979 * r / (k_rows - 1);
        for (std::uint32_t c = 0; c < k_columns; ++c)
          source.positions.emplace_back(-1.0 + 2.0 * c / (k_columns - 1), side * (0.101 - 0.1 * std::sin(turn)),
                                        0.2 * std::cos(turn));
      }
      for (std::uint32_t r = 0; r + 1 < k_rows; ++r) {
        for (std::uint32_t c = 0; c + 1 < k_columns; ++c) {
          const std::uint32_t i = first + r * k_columns + c;
          const mesh::Triangle one{i, i + 1, i + k_columns + 1};
          const mesh::Triangle other{i, i + k_columns + 1, i + k_columns};
          for (const mesh::Triangle& t : {one, other})
            source.triangles.push_back(side > 0 ? mesh::Triangle{t[0], t[2], t[1]} : t);
        }
      }
    }
    mesh = mesh::TriangleMesh::build(std::move(source)).value();
  }

  Lips& control(const char* name, ModelVector upper, ModelVector lower) {
    rig::BlendShape shape;
    shape.parameter = {name, 0, 0, 1};
    for (std::uint32_t v = 0; v < mesh->vertex_count(); ++v) {
      const double x = mesh->positions()[v].x;
      shape.vertices.push_back(v);
      shape.deltas.emplace_back((v < k_rows * k_columns ? upper : lower) * (1 - x * x));
    }
    shapes.push_back(std::move(shape));
    return *this;
  }
  WholeModel ready() {
    rig =
        rig::CharacterRig::make(mesh, {rig::BlendShapes::make(shapes, mesh->vertex_count()).value()}, nullptr).value();
    return measure_whole_model(*rig);
  }
};

TEST(Contacts, AControlThatClosesWhatAnotherOpensDrivesLipsThroughEachOtherAlone) {
  Lips lips;
  lips.control("jaw", {0, 0, 0}, {0, -0.5, 0}).control("close", {0, -0.1, 0}, {0, 0.4, 0});
  lips.control("both up", {0, 0.3, 0}, {0, 0.3, 0}).control("forward", {0, 0, 0.3}, {0, 0, 0.3});
  const WholeModel whole = lips.ready();
  const Contacts& contacts = *whole.contacts;
  ASSERT_FALSE(contacts.vertices().empty());
  EXPECT_GT(contacts.depth(1), 0.1) << "half a unit of lips that span 2.3";
  for (const std::size_t p : {0U, 2U, 3U}) EXPECT_LT(contacts.depth(p), 0.01) << p;
  const std::vector<double> open{1, 0, 0, 0};
  EXPECT_LT(contacts.depth(1, open), 0.01) << "they meet";
  const std::vector<double> rest{0, 0, 0, 0};
  EXPECT_EQ(contacts.depth(1, rest), contacts.depth(1));
}

TEST(Contacts, ASurfaceWithoutAFoldHasNone) {
  tests::Face face;
  face.bump("in", 0, 0, {0, 0, -0.5});
  const WholeModel whole = measure_whole_model(*face.ready().rig);
  EXPECT_TRUE(whole.contacts->vertices().empty());
  EXPECT_EQ(whole.contacts->depth(0), 0);
}

TEST(Contacts, ALineAlongClosedLipsDoesNotMeanWhatOnlyClosesThem) {
  Lips lips;
  lips.control("close", {0, -0.1, 0}, {0, 0.4, 0}).control("both up", {0, 0.35, 0}, {0, 0.4, 0});
  const WholeModel whole = lips.ready();
  const auto front = geometry::Camera::make({{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 30}, {1000, 1000}).value();
  IntentProblem problem;
  DrawnCurve curve{{}, front, {}, k_doubt_px, {}};
  const std::uint32_t row = k_rows * k_columns + 3 * k_columns;  // of the lower lip, seen from the front
  for (std::uint32_t c = 0; c < k_columns; ++c) {
    curve.reference.push_back(posing::at_vertex(row + c));
    const auto at = lips.mesh->positions()[row + c];
    curve.target.push_back(front.project(at + ModelVector{0, 0.2 * (1 - at.x * at.x), 0}).value());
  }
  problem.drawn = {curve};
  problem.start = {0, 0};
  problem.free = {0, 1};
  SolveWorkspace work;
  const Solution solution = solve(*lips.rig, whole, problem, {}, work).value();
  EXPECT_EQ(solution.moved, std::vector<std::size_t>{1});
  EXPECT_NEAR(solution.pose[1], 0.5, 0.05);
}

}  // namespace
}  // namespace penpose::intent
