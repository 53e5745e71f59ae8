#pragma once

#include <string>

#include "core/base/json/json.h"
#include "core/document/document.h"
#include "core/io/project/internal/project_values.h"

namespace penpose::io {

/// How a project is looked at: "views": [{"name", "view", "key" (1..9, if it has one)}], "camera": [command, ...], the
/// keys of the camera that moves along the timeline, and "reference": command, the picture that one animates after; the
/// last two if there are any.
[[nodiscard]] Problem read_project_views(const json::Json& project, const std::string& pointer,
                                         document::Document& out);
void write_project_views(const document::Document& document, json::Json& project);

}  // namespace penpose::io
