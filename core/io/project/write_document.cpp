#include "core/io/project/write_document.h"

#include "core/io/model/formats.h"
#include "core/io/model/write_model.h"

namespace penpose::io {

base::Result<std::vector<std::uint8_t>> write_document(const document::Document& document, std::string_view file_name,
                                                       const GlbOptions& options, GlbReport* report) {
  if (format_of_name(file_name) == Format::glb) return write_project(document, options, report);
  return write_model(document::model_of(document), file_name, options, report);
}

}  // namespace penpose::io
