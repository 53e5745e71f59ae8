#include "core/io/project/read_document.h"

#include <utility>

#include "core/io/gltf/read/read_gltf.h"
#include "core/io/model/formats.h"

namespace penpose::io {

base::Result<document::Document> read_document(base::Bytes bytes, std::string_view file_name_hint,
                                               const FileResolver& resolve) {
  auto format = format_of_content(bytes);
  if (!format) format = format_of_name(file_name_hint);
  if (format == Format::glb || format == Format::gltf) return read_gltf_document(bytes, resolve);
  auto model = read_model(bytes, file_name_hint, resolve);
  if (!model) return model.error();
  return document::make_document(std::move(model).value());
}

}  // namespace penpose::io
