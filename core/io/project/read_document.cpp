#include "core/io/project/read_document.h"

#include <utility>

#include "core/io/model/foreign_file.h"
#include "core/io/model/model_formats.h"

namespace penpose::io {

base::Result<document::Document> read_document(base::Bytes bytes, std::string_view file_name_hint,
                                               const FileResolver& resolve) {
  if (auto foreign = foreign_file(bytes)) return *foreign;
  const ModelFormat* format = format_to_read(bytes, file_name_hint);
  if (format != nullptr && format->read_project != nullptr) return format->read_project(bytes, resolve);
  auto model = read_model(bytes, file_name_hint, resolve);
  if (!model) return model.error();
  return document::make_document(std::move(model).value());
}

}  // namespace penpose::io
