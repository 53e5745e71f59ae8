#pragma once

#include <string>

#include "core/base/json/json.h"
#include "core/document/document.h"
#include "core/io/project/internal/project_values.h"

namespace penpose::io {

/// The curves that pose, "curves" and "last_curve" of a project, into a document that has its model.
[[nodiscard]] Problem read_project_curves(const json::Json& project, const std::string& pointer,
                                          document::Document& out);
[[nodiscard]] json::Json curve_to_json(const document::PoseCurve& curve);

}  // namespace penpose::io
