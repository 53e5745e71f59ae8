#include "core/io/model/write_model.h"

#include "core/io/model/model_formats.h"

namespace penpose::io {

base::Result<std::vector<std::uint8_t>> write_model(const document::Model& model, std::string_view file_name,
                                                    const WriteOptions& options, WriteReport* report) {
  const auto format = format_to_write(file_name);
  if (!format) return format.error();
  WriteReport ignored;
  return (*format)->write(model, options, report == nullptr ? ignored : *report);
}

}  // namespace penpose::io
