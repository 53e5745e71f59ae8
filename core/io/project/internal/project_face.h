#pragma once

#include <string>

#include "core/base/json/json.h"
#include "core/document/document.h"
#include "core/io/project/internal/project_values.h"

namespace penpose::io {

/// The drawings of a face, "face" and "neutral" of a project, into a document that has its curves.
[[nodiscard]] Problem read_project_face(const json::Json& project, const std::string& pointer, document::Document& out);
[[nodiscard]] json::Json face_to_json(const document::FaceDrawing& face);

}  // namespace penpose::io
