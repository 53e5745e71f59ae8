#include "ui/cli/save_model.h"

#include "core/model_io/write_document.h"
#include "core/model_io/write_model.h"
#include "ui/cli/files.h"

namespace penpose::cli {

base::Status save_model(const document::Model& model, const std::string& path) {
  const auto bytes = model_io::write_model(model, path);
  if (!bytes) return bytes.error();
  return write_file(path, *bytes);
}

base::Status save_document(const document::Document& document, const std::string& path) {
  const auto bytes = model_io::write_document(document, path);
  if (!bytes) return bytes.error();
  return write_file(path, *bytes);
}

}  // namespace penpose::cli
