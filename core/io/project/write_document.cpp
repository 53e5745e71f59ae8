#include "core/io/project/write_document.h"

#include "core/io/model/model_formats.h"

namespace penpose::io {

base::Result<std::vector<std::uint8_t>> write_document(const document::Document& document, std::string_view file_name,
                                                       const WriteOptions& options, WriteReport* report) {
  const auto format = format_to_write(file_name);
  if (!format) return format.error();
  WriteReport ignored;
  WriteReport& told = report == nullptr ? ignored : *report;
  WriteOptions named = options;
  named.stem = stem_of(file_name);
  if ((*format)->write_project != nullptr) return (*format)->write_project(document, named, told);
  return (*format)->write(document::model_of(document), named, told);
}

}  // namespace penpose::io
