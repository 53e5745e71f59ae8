#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/document/document.h"
#include "core/io/model/write_model.h"

namespace penpose::io {

/// A project: the binary glTF file of the document's model, pose and timeline, which other programs open as an ordinary
/// model, with all that is needed to go on working under the extras key "penpose". Reads back with the same
/// document::DocumentState.
[[nodiscard]] base::Result<std::vector<std::uint8_t>> write_project(const document::Document& document,
                                                                    const WriteOptions& options = {},
                                                                    WriteReport* report = nullptr);

/// The same as a text file with others beside it (write_gltf).
[[nodiscard]] base::Result<std::vector<std::uint8_t>> write_gltf_project(const document::Document& document,
                                                                         const WriteOptions& options,
                                                                         WriteReport* report);

/// Writes in the format that the file name's extension asks for, as a project where it holds one. Errors: as
/// write_model.
[[nodiscard]] base::Result<std::vector<std::uint8_t>> write_document(const document::Document& document,
                                                                     std::string_view file_name,
                                                                     const WriteOptions& options = {},
                                                                     WriteReport* report = nullptr);

}  // namespace penpose::io
