#include "core/io/model/read_model.h"

#include "core/io/model/foreign_file.h"
#include "core/io/model/model_formats.h"

namespace penpose::io {

base::Result<document::Model> read_model(base::Bytes bytes, std::string_view file_name_hint,
                                         const FileResolver& resolve) {
  if (bytes.empty()) return base::Error{"the file is empty", "byte offset 0", "choose another file"};
  if (auto foreign = foreign_file(bytes)) return *foreign;
  const ModelFormat* format = format_to_read(bytes, file_name_hint);
  if (format == nullptr) return base::Error{"the format is not known", "byte offset 0", "use " + names_read()};
  return format->read(bytes, resolve);
}

}  // namespace penpose::io
