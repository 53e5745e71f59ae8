#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/byte_reader.h"
#include "core/base/result.h"
#include "core/document/model.h"

namespace penpose::io {

/// Gives the bytes of a file that lies beside the model, by its relative path (no "..", no scheme). glTF text files
/// name their buffers so.
using FileResolver = std::function<base::Result<std::vector<std::uint8_t>>(const std::string& path)>;

/// Reads a model of any format that is read (model_formats), told by content, then by the file name's extension. Vertex
/// v of a part is vertex v of the file's primitive or object. What had to be left out is in Model::notes. Every limit
/// is checked before memory is taken; hostile bytes give an error. Errors: place is a byte offset, "line N" or a JSON
/// pointer; for the mesh as a whole "vertex N" or "triangle N".
[[nodiscard]] base::Result<document::Model> read_model(base::Bytes bytes, std::string_view file_name_hint,
                                                       const FileResolver& resolve = {});

}  // namespace penpose::io
