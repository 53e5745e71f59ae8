#include "core/io/model/write_model.h"

#include "core/io/model/formats.h"

namespace penpose::io {

base::Result<std::vector<std::uint8_t>> write_model(const document::Model& model, std::string_view file_name,
                                                    const GlbOptions& options, GlbReport* report) {
  const auto format = format_of_name(file_name);
  if (format == Format::glb) return write_glb(model, options, report);
  if (format == Format::obj) return write_obj(model);
  return base::Error{"the format is not one that can be written", "", "name the file .glb or .obj"};
}

}  // namespace penpose::io
