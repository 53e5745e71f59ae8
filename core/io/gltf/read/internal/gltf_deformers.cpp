#include "core/io/gltf/read/internal/gltf_deformers.h"

#include <algorithm>
#include <set>

#include "core/io/gltf/write/deformer_sample.h"

namespace penpose::io {
namespace {

/// Share of the model's diagonal that a deformer may be off its target: the target is rounded to float, no more.
constexpr double k_same = 1e-5;
/// The same where an older edition made the target: so far a control may be built otherwise today and still be drawn
/// on. A third of a millimetre on a head.
constexpr double k_alike = 1e-3;

std::string note(const std::string& name, const std::string& why) {
  return "deformer " + name + " cannot be built again from its strokes and stays a blend shape: " + why;
}

}  // namespace

std::shared_ptr<const articulation::SketchedDeformers> read_deformers(
    const std::shared_ptr<const mesh::TriangleMesh>& mesh, const rig::Skeleton* skeleton, const RootExtras& extras,
    const GltfShapes& shapes, std::vector<std::string>& notes) {
  if (extras.deformers.empty()) return nullptr;
  const auto canvas = articulation::Canvas::make(mesh, skeleton);
  if (!canvas) return nullptr;
  std::vector<std::shared_ptr<const articulation::Deformer>> deformers;
  const bool older = extras.older_edition > 0;
  const double tolerance = older ? k_alike : k_same;
  std::set<std::string> names;
  for (const rig::Parameter& shape : extras.shapes) names.insert(shape.name);
  for (const articulation::Sketch& sketch : extras.deformers) {
    if (!names.insert(sketch.name).second) {
      notes.push_back(note(sketch.name, "another control has its name"));
      continue;
    }
    auto deformer = articulation::build_deformer(sketch, **canvas);
    if (!deformer) {
      notes.push_back(note(sketch.name, deformer.error().what));
      continue;
    }
    const auto target = std::find_if(shapes.shapes.begin(), shapes.shapes.end(),
                                     [&](const rig::BlendShape& shape) { return shape.parameter.name == sketch.name; });
    if (target != shapes.shapes.end() && !is_sample_of(*target, **deformer, tolerance * mesh->rest_box().diagonal())) {
      notes.push_back(note(sketch.name, older ? "what it was drawn to do is read otherwise today"
                                              : "the model has changed since it was drawn"));
      continue;
    }
    deformers.push_back(std::move(deformer).value());
  }
  if (deformers.empty()) return nullptr;
  auto made = articulation::SketchedDeformers::make(std::move(deformers));
  return made ? std::move(made).value() : nullptr;
}

}  // namespace penpose::io
