#include "core/io/model/write_model.h"

#include "core/io/model/model_formats.h"

namespace penpose::io {

std::string stem_of(std::string_view file_name) {
  const std::size_t folder = file_name.find_last_of('/');
  if (folder != std::string_view::npos) file_name.remove_prefix(folder + 1);
  return std::string(file_name.substr(0, file_name.find_last_of('.')));
}

base::Result<std::vector<std::uint8_t>> write_model(const document::Model& model, std::string_view file_name,
                                                    const WriteOptions& options, WriteReport* report) {
  const auto format = format_to_write(file_name);
  if (!format) return format.error();
  WriteReport ignored;
  WriteOptions named = options;
  named.stem = stem_of(file_name);
  return (*format)->write(model, named, report == nullptr ? ignored : *report);
}

}  // namespace penpose::io
