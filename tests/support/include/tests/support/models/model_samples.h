#pragma once

#include <glm/gtc/matrix_transform.hpp>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/document/model.h"

namespace penpose::tests {

/// Adds a square of side 1 in the plane z = 0 with its low corner at (x, 0, 0), as a part.
inline void add_square(mesh::MeshSource& source, const std::string& name, double x) {
  const auto v = static_cast<std::uint32_t>(source.positions.size());
  const auto t = static_cast<std::uint32_t>(source.triangles.size());
  source.positions.insert(source.positions.end(), {{x, 0, 0}, {x + 1, 0, 0}, {x + 1, 1, 0}, {x, 1, 0}});
  source.triangles.push_back({v, v + 1, v + 2});
  source.triangles.push_back({v, v + 2, v + 3});
  source.parts.push_back({name, v, 4, t, 2});
}

inline document::Model must_make(mesh::MeshSource source, std::vector<rig::BlendShape> shapes,
                                 std::vector<rig::Joint> joints,
                                 const std::vector<std::vector<rig::Influence>>& influences) {
  auto mesh = mesh::TriangleMesh::build(std::move(source)).value();
  std::shared_ptr<const rig::BlendShapes> blend;
  if (!shapes.empty()) blend = rig::BlendShapes::make(std::move(shapes), mesh->vertex_count()).value();
  std::shared_ptr<const rig::Skeleton> skeleton;
  if (!joints.empty()) {
    std::vector<std::uint32_t> first{0};
    std::vector<rig::Influence> all;
    for (const auto& of_vertex : influences) {
      all.insert(all.end(), of_vertex.begin(), of_vertex.end());
      first.push_back(static_cast<std::uint32_t>(all.size()));
    }
    skeleton = rig::Skeleton::make(std::move(joints), std::move(first), std::move(all)).value();
  }
  return document::make_model(mesh, blend, skeleton).value();
}

/// A model that uses everything a model can hold: parts that are free, rigid (two on one joint), skinned, and skinned
/// with vertices that nothing carries; joints with several roots, ranges, a bind matrix that needs doubles and a turned
/// pose; shapes across parts in an order of their own, one that moves nothing and one with listed zeros and normals;
/// curves, materials, and animations of every kind.
inline document::Model full_model() {
  mesh::MeshSource source;
  const char* names[] = {"free", "eye", "lid", "arm", ""};
  for (int i = 0; i < 5; ++i) add_square(source, names[i], 2.0 * i);

  std::vector<rig::Joint> joints(4);
  joints[0].name = "base";
  joints[0].posable = false;
  joints[0].rest_rotation = glm::dquat(2, 0, 0, 0);  // not of length one, as a file may have it
  joints[1].name = "ball";
  joints[1].parent = 0;
  joints[1].translation = {0.1, 0.2, 0.3};
  joints[1].minimum = glm::dvec3(-0.5);
  joints[2].name = "bone";
  joints[2].translation = {6, 0, 0};
  joints[2].scale = {1, 2, 1};
  joints[2].inverse_bind = glm::translate(glm::dmat4(1), glm::dvec3(-6.1, 0, 0));
  joints[3].name = "tip";
  joints[3].parent = 2;
  joints[3].inverse_bind = glm::translate(glm::dmat4(1), glm::dvec3(-7.5, 0.25, 0));
  std::vector<std::vector<rig::Influence>> influences(20);
  for (std::size_t v = 4; v < 12; ++v) influences[v] = {{1, 1.0}};
  for (std::size_t v = 12; v < 16; ++v) influences[v] = {{2, 0.75}, {3, 0.25}};
  influences[17] = {{2, 1.0}};

  std::vector<rig::BlendShape> shapes(4);
  shapes[0].parameter = {"second part first", 0, 0, 1};
  shapes[0].vertices = {5, 12};
  shapes[0].deltas = {{0, 0, 0.5F}, {0.25F, 0, 0}};
  shapes[1].parameter = {"all over", 0.25, -1, 2};
  for (std::uint32_t v = 0; v < 20; ++v) {
    shapes[1].vertices.push_back(v);
    shapes[1].deltas.emplace_back(0.1F * static_cast<float>(v + 1), 0, 0);
  }
  shapes[2].parameter = {"nothing", 0, 0, 1};
  shapes[3].parameter = {"listed zero", 0, 0, 1};
  shapes[3].vertices = {0, 1, 2, 3};
  shapes[3].deltas = {{0, 0, 1}, {0, 0, 0}, {0, 0, 1}, {0, 1, 0}};
  shapes[3].normal_deltas = {{0, 0.5F, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};

  document::Model model = must_make(std::move(source), std::move(shapes), std::move(joints), influences);
  model.pose = {0.5, -0.75, 0, 1, 0.1, -0.2, 0.3, 0.4, 0, 0, -1, 0.5, 0.25};
  model.materials[1] = {"glass", {0.1, 0.2, 0.3, 0.5}, 0.25, 0.75};
  model.curves = {{"brow", {{0, {0.25, 0.25, 0.5}}, {1, {1, 0, 0}}}}, {"lip", {{9, {0.1, 0.2, 0.7}}}}};
  document::Animation animation;
  animation.name = "wave";
  document::Channel of_shapes;
  of_shapes.times_s = {0, 0.5, 2};
  for (int i = 0; i < 12; ++i) of_shapes.values.push_back(0.0625 * i);
  animation.channels.push_back(of_shapes);
  using enum document::ChannelTarget;
  animation.channels.push_back({rotation, 1, document::Interpolation::step, {0, 1}, {0, 0, 0, 1, 1, 0, 0, 0}});
  animation.channels.push_back({scale, 2, document::Interpolation::linear, {0, 1}, {1, 1, 1, 2, 2, 2}});
  document::Channel spline{translation, 3, document::Interpolation::cubic_spline, {0, 1}, {}};
  for (int i = 0; i < 18; ++i) spline.values.push_back(0.25 * i);
  animation.channels.push_back(spline);
  model.animations = {animation};
  return model;
}

/// A part whose triangles all lost their area, beside a real one.
inline document::Model model_with_empty_part() {
  mesh::MeshSource source;
  add_square(source, "real", 0);
  add_square(source, "flat", 2);
  source.triangles[2] = {4, 4, 5};
  source.triangles[3] = {5, 6, 6};
  return must_make(std::move(source), {}, {}, {});
}

}  // namespace penpose::tests
