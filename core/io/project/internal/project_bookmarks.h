#pragma once

#include <memory>
#include <string>

#include "core/base/json/json.h"
#include "core/document/document.h"
#include "core/io/project/internal/project_values.h"

// The member "bookmarks" of a project and of its clips.

namespace penpose::io {

[[nodiscard]] json::Json bookmarks_to_json(const document::Bookmarks& bookmarks);
/// Reads them where an object has some.
[[nodiscard]] Problem read_bookmarks(const json::Json& object, const std::string& pointer,
                                     std::shared_ptr<const document::Bookmarks>& out);
/// Reads those of the clip that is shown.
[[nodiscard]] Problem read_project_bookmarks(const json::Json& project, const std::string& pointer,
                                             document::Document& out);

}  // namespace penpose::io
