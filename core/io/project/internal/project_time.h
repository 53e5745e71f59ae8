#pragma once

#include "core/base/json/json.h"
#include "core/document/document.h"
#include "core/io/project/internal/project_values.h"

// The member "timeline" of a project.

namespace penpose::io {

[[nodiscard]] json::Json timeline_to_json(const document::Document& document);
/// Reads it into a document that has its model already; a project without one has no keys.
[[nodiscard]] Problem read_timeline(const json::Json& project, const std::string& pointer, document::Document& out);

}  // namespace penpose::io
