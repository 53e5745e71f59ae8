#pragma once

#include <string>
#include <vector>

#include "core/base/json/json.h"
#include "core/base/result.h"

namespace penpose::io {

/// The part of a glTF document that penpose reads, checked: every member is of the type and in the range that the
/// specification gives (Khronos glTF 2.0, chapter 5; an optional member may also be null), every index points at
/// something that exists, the nodes form trees, and an indices accessor has data, or a Draco stream that gives it.
/// Extensions that the file requires are looked at before anything else. Channels of animations without a node are left
/// out. Members that are not needed (textures, cameras, extras, extensions) are not in it, so that a parser given this
/// sees nothing unchecked. What was left out is added to `notes`, one line each. Errors: place is a JSON pointer.
[[nodiscard]] base::Result<json::Json> vet_gltf(const json::Json& document, std::vector<std::string>& notes);

}  // namespace penpose::io
