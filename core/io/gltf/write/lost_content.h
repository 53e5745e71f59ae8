#pragma once

#include <string>

#include "core/document/model.h"

namespace penpose::io {

/// What of the file that a model was read from only a patched one keeps, "textures, vertex colours"; empty: nothing.
[[nodiscard]] std::string lost_without_source(const document::Model& model);

}  // namespace penpose::io
