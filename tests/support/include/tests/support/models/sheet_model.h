#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/document/document.h"
#include "core/document/model.h"

namespace penpose::tests {

/// A bent sheet of 15 x 15 vertices with two blend shapes and a joint: small, and made without any function of a
/// platform's library.
inline document::Model sheet_model() {
  constexpr std::uint32_t k_side = 15;
  mesh::MeshSource source;
  std::vector<rig::BlendShape> shapes(2);
  shapes[0].parameter = {"lift", 0, 0, 1};
  shapes[1].parameter = {"lean", 0, -1, 1};
  for (std::uint32_t i = 0; i < k_side; ++i) {
    for (std::uint32_t j = 0; j < k_side; ++j) {
      const double x = -1.0 + 2.0 * j / (k_side - 1);
      const double y = -1.0 + 2.0 * i / (k_side - 1);
      source.positions.emplace_back(x, y, 0.4 * (1.0 - 0.5 * (x * x + y * y)));
      const auto v = static_cast<std::uint32_t>(source.positions.size() - 1);
      if (y > 0) {
        shapes[0].vertices.push_back(v);
        shapes[0].deltas.emplace_back(0, 0.4F * static_cast<float>(y), 0.1F * static_cast<float>(y));
      }
      shapes[1].vertices.push_back(v);
      shapes[1].deltas.emplace_back(0.3F * static_cast<float>(x * x), 0, 0);
    }
  }
  for (std::uint32_t i = 0; i + 1 < k_side; ++i) {
    for (std::uint32_t j = 0; j + 1 < k_side; ++j) {
      const std::uint32_t a = i * k_side + j;
      source.triangles.push_back({a, a + 1, a + k_side + 1});
      source.triangles.push_back({a, a + k_side + 1, a + k_side});
    }
  }
  source.parts = {{"sheet", 0, k_side * k_side, 0, static_cast<std::uint32_t>(source.triangles.size())}};
  const auto mesh = mesh::TriangleMesh::build(source).value();
  std::vector<rig::Joint> joints(1);
  joints[0].name = "base";
  std::vector<std::uint32_t> first;
  std::vector<rig::Influence> influences;
  for (std::uint32_t v = 0; v <= mesh->vertex_count(); ++v) {
    first.push_back(v);
    if (v < mesh->vertex_count()) influences.push_back({0, 1});
  }
  return document::make_model(mesh, rig::BlendShapes::make(shapes, mesh->vertex_count()).value(),
                              rig::Skeleton::make(joints, first, influences).value())
      .value();
}

/// Opens the sheet whatever a session names.
inline base::Result<document::Document> open_sheet(const std::string&) {
  return document::make_document(sheet_model());
}

}  // namespace penpose::tests
