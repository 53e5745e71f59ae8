#include "core/model_io/read_model.h"

#include "core/model_io/read_gltf.h"

namespace penpose::model_io {

base::Result<document::Model> read_model(base::Bytes bytes, std::string_view, const FileResolver& resolve) {
  return read_gltf(bytes, resolve);
}

}  // namespace penpose::model_io
