#include "core/model_io/write_document.h"

#include "core/model_io/formats.h"
#include "core/model_io/write_model.h"

namespace penpose::model_io {

base::Result<std::vector<std::uint8_t>> write_document(const document::Document& document, std::string_view file_name,
                                                       const GlbOptions& options, GlbReport* report) {
  if (format_of_name(file_name) == Format::glb) return write_project(document, options, report);
  return write_model(document::model_of(document), file_name, options, report);
}

}  // namespace penpose::model_io
