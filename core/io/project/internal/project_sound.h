#pragma once

#include <string>

#include "core/base/json/json.h"
#include "core/document/document.h"
#include "core/io/project/internal/project_values.h"

namespace penpose::io {

/// "sound", "mouths" and "spoken" of a project, where it has them. Controls that are gone are left out.
[[nodiscard]] Problem read_project_sound(const json::Json& project, const std::string& pointer,
                                         document::Document& out);
void write_project_sound(const document::Document& document, json::Json& project);

}  // namespace penpose::io
