#pragma once

#include <memory>
#include <string>

#include "core/base/json/json.h"
#include "core/document/document.h"
#include "core/io/project/internal/project_values.h"

namespace penpose::io {

/// "sound", "mouths" and "spoken" of a project, where it has them. Controls that are gone are left out.
[[nodiscard]] Problem read_project_sound(const json::Json& project, const std::string& pointer,
                                         document::Document& out);
/// The member "spoken" of a project or of a clip of it, where it has one.
[[nodiscard]] Problem read_spoken(const json::Json& object, const std::string& pointer, const document::Mouths& mouths,
                                  std::shared_ptr<const document::SpokenMouths>& out);
void write_spoken(const document::SpokenMouths& spoken, json::Json& object);
void write_project_sound(const document::Document& document, json::Json& project);

}  // namespace penpose::io
