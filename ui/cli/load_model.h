#pragma once

#include <string>

#include "core/base/result.h"
#include "core/document/document.h"

namespace penpose::cli {

/// Opens and reads a model, and the files beside it that it names; "builtin:head" is the built-in head and
/// "builtin:demo" the same with the deformers of the demo. Errors of the file system and of the reader.
[[nodiscard]] base::Result<document::Model> load_model(const std::string& path);

/// The same as a document: of a project with all that it keeps beyond its model.
[[nodiscard]] base::Result<document::Document> load_document(const std::string& path);

/// Sets one parameter of the model's pose from "NAME=VALUE". Errors: no "=", no number, no parameter of that name (the
/// closest one is suggested), a value outside its range.
[[nodiscard]] base::Status set_parameter(document::Model& model, const std::string& assignment);

}  // namespace penpose::cli
