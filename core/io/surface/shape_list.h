#pragma once

#include <span>
#include <string>

#include "core/base/result.h"
#include "core/document/model.h"

namespace penpose::io {

/// A model that shows another one with a control at 1, such as an OBJ file of one expression.
struct ShownShape {
  std::string name;
  document::Model model;
};

/// The name of a control from a file's: without folders and extension.
[[nodiscard]] std::string control_name_of(const std::string& path);

/// The model with a blend shape for each of the others: what differs from the model's rest vertices. Its own blend
/// shapes come first; names that are taken get a number; pose and animations stay. Errors (place: the shape's name):
/// another number of vertices.
[[nodiscard]] base::Result<document::Model> with_shapes(document::Model model, std::span<const ShownShape> shapes);

}  // namespace penpose::io
