#pragma once

#include <string>

#include "core/base/result.h"
#include "core/document/model.h"

namespace penpose::cli {

/// Writes a model in the format that the path's extension asks for, atomically. Errors of the writer and of the file
/// system.
[[nodiscard]] base::Status save_model(const document::Model& model, const std::string& path);

}  // namespace penpose::cli
