#include "core/portrait/features/find_features.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <string>

#include "core/base/math.h"
#include "core/character/demo_head.h"
#include "core/intent/model/whole_model.h"
#include "tests/core/portrait/feature_distance.h"

namespace penpose::portrait {
namespace {

using geometry::ModelPoint;

/// The built-in head as any program might have written it: shapes without telling names, one part, and what a test
/// changes.
struct Head {
  std::shared_ptr<const mesh::TriangleMesh> mesh;
  std::shared_ptr<const rig::CharacterRig> rig;
  std::map<std::string, tests::Line> curves;  ///< as the head itself has them
  double front_yaw_degrees = 0;
};

struct Change {
  double scale = 1;
  double yaw_degrees = 0;
  bool mirrored = false;
  bool shuffled = false;
  bool without_shapes = false;
};

const document::Model& demo() {
  static const document::Model model = character::make_demo_head().value();
  return model;
}

/// 0, 1, 2, ... in another order.
std::vector<std::uint32_t> order_of(std::size_t count, bool shuffled) {
  std::vector<std::uint32_t> order(count);
  for (std::uint32_t i = 0; i < count; ++i) order[i] = i;
  std::uint64_t state = 7;
  for (std::size_t i = count; shuffled && i > 1; --i) {
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    std::swap(order[i - 1], order[(state >> 33U) % i]);
  }
  return order;
}

Head changed(const Change& change) {
  const document::Model& model = demo();
  const double cosine = base::cos(base::radians(change.yaw_degrees));
  const double sine = base::sin(base::radians(change.yaw_degrees));
  const auto moved = [&](ModelPoint p) {
    if (change.mirrored) p.x = -p.x;
    return ModelPoint{cosine * p.x + sine * p.z, p.y, -sine * p.x + cosine * p.z} * change.scale;
  };
  std::vector<ModelPoint> rest(model.mesh->vertex_count());
  rig::Pose pose = rig::rest_pose(*model.rig);
  model.rig->evaluate(pose, rest);
  const std::vector<std::uint32_t> order = order_of(rest.size(), change.shuffled);
  std::vector<std::uint32_t> number(rest.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) number[order[i]] = i;

  mesh::MeshSource source;
  for (const std::uint32_t v : order) source.positions.push_back(moved(rest[v]));
  for (const std::uint32_t t : order_of(model.mesh->triangle_count(), change.shuffled)) {
    mesh::Triangle triangle = model.mesh->triangles()[t];
    for (std::uint32_t& v : triangle) v = number[v];
    if (change.mirrored) std::swap(triangle[0], triangle[1]);
    source.triangles.push_back(triangle);
  }
  Head head;
  head.front_yaw_degrees = change.yaw_degrees;
  head.mesh = mesh::TriangleMesh::build(std::move(source)).value();

  std::vector<rig::BlendShape> shapes;
  const auto parameters = model.rig->parameters();
  for (std::size_t k = 0; k < parameters.size() && !change.without_shapes; ++k) {
    pose = rig::rest_pose(*model.rig);
    pose[k] = parameters[k].maximum;
    std::vector<ModelPoint> there(rest.size());
    model.rig->evaluate(pose, there);
    rig::BlendShape shape;
    shape.parameter.name = std::to_string(k);
    for (std::uint32_t i = 0; i < order.size(); ++i) {
      const ModelPoint way = moved(there[order[i]]) - moved(rest[order[i]]);
      if (!(geometry::length(way) > 0.0)) continue;
      shape.vertices.push_back(i);
      shape.deltas.emplace_back(way);
    }
    shapes.push_back(std::move(shape));
  }
  std::vector<std::shared_ptr<const rig::DisplacementLayer>> layers;
  layers.push_back(rig::BlendShapes::make(std::move(shapes), rest.size()).value());
  head.rig = rig::CharacterRig::make(head.mesh, layers, nullptr).value();

  for (const document::NamedCurve& curve : model.curves) {
    std::string name = curve.name == "lip_upper" || curve.name == "lip_lower" ? curve.name + "_outer" : curve.name;
    if (change.mirrored && name.ends_with("_L")) {
      name.back() = 'R';
    } else if (change.mirrored && name.ends_with("_R")) {
      name.back() = 'L';
    }
    for (const mesh::MeshPoint& p : curve.points) {
      head.curves[name].push_back(moved(mesh::position_of(p, model.mesh->triangles(), rest)));
    }
  }
  return head;
}

std::vector<FoundCurve> found_on(const Head& head) {
  return find_features(*head.rig, *head.mesh, intent::measure_whole_model(*head.rig), head.front_yaw_degrees);
}

tests::Line places_of(const Head& head, const FoundCurve& found) {
  std::vector<ModelPoint> rest(head.rig->vertex_count());
  head.rig->evaluate(rig::rest_pose(*head.rig), rest);
  return tests::places_of(found.curve, rest);
}

const FoundCurve* named(const std::vector<FoundCurve>& all, const std::string& name) {
  const auto at = std::find_if(all.begin(), all.end(), [&](const FoundCurve& f) { return f.curve.name == name; });
  return at == all.end() ? nullptr : &*at;
}

const std::vector<std::string> k_seams{"lip_upper_inner", "lip_lower_inner"};
const std::vector<std::string> k_borders{"lip_upper_outer", "lip_lower_outer"};
const std::vector<std::string> k_lids{"eyelid_upper_L", "eyelid_upper_R", "eyelid_lower_L", "eyelid_lower_R"};
const std::vector<std::string> k_brows{"brow_L", "brow_R"};

/// Curves are within 3 % of the eyes' distance of the head's own; `or_unsure`: others say so.
void expect_near(const Head& head, const std::vector<FoundCurve>& found, const std::vector<std::string>& names,
                 bool or_unsure = false) {
  const double distance = tests::eye_distance(head.curves);
  for (const std::string& name : names) {
    const FoundCurve* curve = named(found, name);
    ASSERT_NE(curve, nullptr) << name;
    const double off = tests::mean_distance(places_of(head, *curve), head.curves.at(name)) / distance;
    if (or_unsure && curve->sureness < k_sure) continue;
    EXPECT_LT(off, 0.03) << name << " sure " << curve->sureness;
    EXPECT_GE(curve->sureness, k_sure) << name;
  }
}

void expect_all_near(const Head& head) {
  const auto found = found_on(head);
  expect_near(head, found, k_seams);
  expect_near(head, found, k_borders, true);
  expect_near(head, found, k_lids);
  expect_near(head, found, k_brows, true);
}

TEST(FindFeatures, FindsLipsAndLidsOfAHeadWithoutNames) {
  const Head head = changed({});
  expect_all_near(head);
}

TEST(FindFeatures, FindsBrowsAndLipsThatAreAMaterialOfTheirOwn) {
  Head head = changed({});
  head.mesh = demo().mesh;
  head.rig = demo().rig;
  expect_near(head, found_on(head), k_brows);
  expect_near(head, found_on(head), k_borders);
}

TEST(FindFeatures, FindsThemWhateverTheSizeTheFrontAndTheOrder) {
  for (const Change& change :
       {Change{.scale = 170}, Change{.yaw_degrees = 90}, Change{.yaw_degrees = -150, .shuffled = true},
        Change{.scale = 0.01, .mirrored = true, .shuffled = true}}) {
    SCOPED_TRACE(testing::Message() << change.scale << " " << change.yaw_degrees << " " << change.shuffled);
    const Head head = changed(change);
    expect_all_near(head);
  }
}

TEST(FindFeatures, RunsAsTheLandmarksOfOtherHeadsDo) {
  const Head head = changed({});
  const auto found = found_on(head);
  for (const char* name : {"lip_upper_outer", "lip_lower_outer", "lip_upper_inner", "lip_lower_inner"}) {
    const tests::Line line = places_of(head, *named(found, name));
    EXPECT_LT(line.front().x, line.back().x) << name;
  }
  for (const char* name : {"eyelid_upper_L", "eyelid_lower_L", "brow_L"}) {
    const tests::Line line = places_of(head, *named(found, name));
    EXPECT_GT(line.front().x, line.back().x) << name;
  }
  for (const char* name : {"eyelid_upper_R", "eyelid_lower_R", "brow_R"}) {
    const tests::Line line = places_of(head, *named(found, name));
    EXPECT_LT(line.front().x, line.back().x) << name;
  }
  const tests::Line bridge = places_of(head, *named(found, "nose_bridge"));
  EXPECT_GT(bridge.front().y, bridge.back().y);
  EXPECT_GT(bridge.back().z, bridge.front().z);
  const tests::Line jaw = places_of(head, *named(found, "jaw"));
  EXPECT_LT(jaw.front().x, jaw.back().x);
}

TEST(FindFeatures, IsTheSameEveryTime) {
  const Head head = changed({.yaw_degrees = 20, .shuffled = true});
  const auto first = found_on(head);
  const auto second = found_on(head);
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].curve.name, second[i].curve.name);
    EXPECT_EQ(first[i].sureness, second[i].sureness);
    ASSERT_EQ(first[i].curve.points.size(), second[i].curve.points.size());
    for (std::size_t p = 0; p < first[i].curve.points.size(); ++p) {
      EXPECT_EQ(first[i].curve.points[p].vertex, second[i].curve.points[p].vertex);
      EXPECT_EQ(first[i].curve.points[p].weight, second[i].curve.points[p].weight);
    }
  }
}

TEST(FindFeatures, WithoutControlsBrowsAreUnsure) {
  const Head head = changed({.without_shapes = true});
  const auto found = found_on(head);
  for (const std::string& name : k_brows) {
    const FoundCurve* brow = named(found, name);
    EXPECT_TRUE(brow == nullptr || brow->sureness < k_sure) << name;
  }
  expect_near(head, found, k_lids, true);
}

/// A shape that has no face.
Head rig_of(std::vector<ModelPoint> positions, std::vector<mesh::Triangle> triangles) {
  Head head;
  head.mesh = mesh::TriangleMesh::build({std::move(positions), {}, std::move(triangles), {}}).value();
  head.rig = rig::CharacterRig::make(head.mesh, {}, nullptr).value();
  return head;
}

TEST(FindFeatures, FindsNothingSureWhereThereIsNoFace) {
  const Head tetrahedron =
      rig_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
  const Head flat = rig_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  const Head line = rig_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}});
  const Head points = rig_of({{0, 0, 0}, {1, 0, 0}}, {});
  for (const Head* head : {&tetrahedron, &flat, &line, &points}) {
    for (const double yaw : {0.0, 77.0, std::nan("")}) {
      for (const FoundCurve& found :
           find_features(*head->rig, *head->mesh, intent::measure_whole_model(*head->rig), yaw)) {
        EXPECT_LT(found.sureness, k_sure) << found.curve.name;
      }
    }
  }
}

}  // namespace
}  // namespace penpose::portrait
