#pragma once

#include <tiny_gltf.h>

#include "core/base/result.h"
#include "core/model_io/json.h"

namespace penpose::model_io {

/// The members of a document that vet_gltf has checked, in tinygltf's terms. Its own reader is not asked: it keeps the
/// text as JSON of the common type, whose destructor takes memory (see json.h). Errors: place is a JSON pointer (a type
/// of accessors or a stride that glTF has not, a channel without a node).
[[nodiscard]] base::Result<tinygltf::Model> gltf_structure(const Json& vetted);

}  // namespace penpose::model_io
