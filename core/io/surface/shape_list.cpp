#include "core/io/surface/shape_list.h"

#include "core/base/text/utf8.h"
#include "core/io/text/names.h"

namespace penpose::io {

std::string control_name_of(const std::string& path) {
  const std::size_t slash = path.find_last_of("/\\");
  const std::string file = slash == std::string::npos ? path : path.substr(slash + 1);
  const std::size_t dot = file.rfind('.');
  return dot == std::string::npos || dot == 0 ? file : file.substr(0, dot);
}

base::Result<document::Model> with_shapes(document::Model model, std::span<const ShownShape> shapes) {
  std::vector<rig::BlendShape> all;
  if (model.shapes) all.assign(model.shapes->shapes().begin(), model.shapes->shapes().end());
  const std::size_t own = all.size();
  std::vector<std::string> names;
  for (const rig::BlendShape& shape : all) names.push_back(shape.parameter.name);
  for (const ShownShape& shown : shapes) names.push_back(base::valid_utf8(shown.name));
  make_unique(names);
  const auto rest = model.mesh->positions();
  const double size = model.mesh->rest_box().diagonal();
  for (std::size_t s = 0; s < shapes.size(); ++s) {
    const auto moved = shapes[s].model.mesh->positions();
    if (moved.size() != rest.size()) {
      return base::Error{"has " + std::to_string(moved.size()) + " vertices, the model " + std::to_string(rest.size()),
                         shapes[s].name, "export both with the same vertices in the same order"};
    }
    rig::BlendShape& shape = all.emplace_back();
    shape.parameter.name = names[own + s];
    for (std::uint32_t v = 0; v < rest.size(); ++v) {
      const geometry::ModelVector delta = moved[v] - rest[v];
      // Files of text round; what is below that is no movement.
      if (geometry::length(delta) <= 1e-7 * size) continue;
      shape.vertices.push_back(v);
      shape.deltas.emplace_back(delta);
    }
  }
  auto made = rig::BlendShapes::make(std::move(all), rest.size());
  if (!made) return made.error();
  auto deformers = model.deformers;
  return document::with_controls(std::move(model), std::move(made).value(), std::move(deformers));
}

}  // namespace penpose::io
