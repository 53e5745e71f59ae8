#pragma once

#include <string>

#include "core/base/result.h"
#include "core/document/document.h"

namespace penpose::cli {

/// Writes a model in the format that the path's extension asks for, atomically. Errors of the writer and of the file
/// system.
[[nodiscard]] base::Status save_model(const document::Model& model, const std::string& path);
/// Writes a document, .glb as a project, atomically. Errors of the writer and of the file system.
[[nodiscard]] base::Status save_document(const document::Document& document, const std::string& path);

}  // namespace penpose::cli
