#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/byte_reader.h"
#include "core/base/result.h"
#include "core/document/document.h"
#include "core/io/model/read_model.h"
#include "core/io/model/write_model.h"

namespace penpose::io {

/// A format of models: what the program knows of it. What a format does not do is null or empty.
struct ModelFormat {
  using Written = base::Result<std::vector<std::uint8_t>>;

  std::string_view name;       ///< as people call it: "OBJ"
  std::string_view extension;  ///< of its files, in lower case: ".obj"
  /// Whether the bytes leave no doubt that they are of it.
  bool (*looks_like)(base::Bytes bytes) = nullptr;
  base::Result<document::Model> (*read)(base::Bytes bytes, const FileResolver& resolve) = nullptr;
  /// With what a project keeps beyond its model.
  base::Result<document::Document> (*read_project)(base::Bytes bytes, const FileResolver& resolve) = nullptr;
  Written (*write)(const document::Model& model, const WriteOptions& options, WriteReport& report) = nullptr;
  Written (*write_project)(const document::Document& document, const WriteOptions& options,
                           WriteReport& report) = nullptr;
  std::string_view holds = {};   ///< what a file of it holds, where one is chosen to export to: "This pose alone"
  std::string_view detail = {};  ///< more of that
};

/// All formats, in the order in which their bytes are tried.
[[nodiscard]] std::span<const ModelFormat> model_formats();

/// The format that the extension of a file name stands for, in upper or lower case; null: none.
[[nodiscard]] const ModelFormat* format_of_name(std::string_view file_name);
/// The format that the bytes show where they leave no doubt; null: none.
[[nodiscard]] const ModelFormat* format_of_content(base::Bytes bytes);
/// The format to read a file by: that of its content, or else of its name. Null where none reads it.
[[nodiscard]] const ModelFormat* format_to_read(base::Bytes bytes, std::string_view file_name_hint);
/// The format to write a file in, by its name. Errors: none writes it.
[[nodiscard]] base::Result<const ModelFormat*> format_to_write(std::string_view file_name);

[[nodiscard]] std::vector<std::string> extensions_read();
[[nodiscard]] std::vector<std::string> extensions_written();
/// The names of the formats that are read, "A, B or C".
[[nodiscard]] std::string names_read();
/// The extensions that are written, ".a, .b or .c".
[[nodiscard]] std::string extensions_to_write();
/// Whether a file of that name keeps controls, keys and all else of a project.
[[nodiscard]] bool keeps_everything(std::string_view file_name);
/// The extensions of such files, ".a, .b or .c".
[[nodiscard]] std::string extensions_that_keep_everything();

}  // namespace penpose::io
