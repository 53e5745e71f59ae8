#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/document/model.h"
#include "core/mesh/triangle_mesh.h"

namespace penpose::io {

/// The model of a file that holds nothing but a surface: no rig, plain materials, and the notes.
[[nodiscard]] base::Result<document::Model> surface_model(mesh::MeshSource source, std::vector<std::string> notes);

}  // namespace penpose::io
