#pragma once

#include "core/base/byte_reader.h"
#include "core/base/result.h"
#include "core/document/document.h"
#include "core/io/model/read_model.h"

namespace penpose::io {

/// Reads binary or text glTF 2.0 (Khronos). Errors as of read_model.
[[nodiscard]] base::Result<document::Model> read_gltf(base::Bytes bytes, const FileResolver& resolve = {});
/// The same with what a project keeps beyond its model.
[[nodiscard]] base::Result<document::Document> read_gltf_document(base::Bytes bytes, const FileResolver& resolve = {});

}  // namespace penpose::io
