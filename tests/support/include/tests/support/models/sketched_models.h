#pragma once

#include "core/document/model.h"
#include "tests/support/models/articulation_models.h"

namespace penpose::tests {

/// The trunk as a model without a rig.
inline document::Model bare_trunk(const Trunk& trunk) {
  mesh::MeshSource source;
  source.positions.assign(trunk.canvas->positions().begin(), trunk.canvas->positions().end());
  source.triangles.assign(trunk.canvas->mesh().triangles().begin(), trunk.canvas->mesh().triangles().end());
  return document::make_model(mesh::TriangleMesh::build(std::move(source)).value(), nullptr, nullptr).value();
}

/// The same with one control, which curls it up by rotation.
inline document::Model curling_trunk() {
  const Trunk trunk = make_trunk();
  auto model = bare_trunk(trunk);
  const auto deformer = articulation::build_deformer(trunk.curl(), *document::make_canvas(model).value()).value();
  return document::with_deformers(std::move(model), articulation::SketchedDeformers::make({deformer}).value()).value();
}

}  // namespace penpose::tests
