#pragma once

#include <optional>

#include "core/base/json/json.h"
#include "core/base/result.h"

namespace penpose::io {

// What a schema cannot say of a glTF document. `vetted`: as far as vet_gltf has come. Errors: place is a JSON pointer.

/// Whether every extension that the document requires can be read, or passed over.
[[nodiscard]] std::optional<base::Error> check_extensions(const json::Json& document);
/// Every node has one parent at most, and following parents always ends.
[[nodiscard]] std::optional<base::Error> check_tree(const json::Json& vetted);
/// Indices that a Draco stream gives need no data of their own.
[[nodiscard]] std::optional<base::Error> check_indices(const json::Json& vetted, const json::Json& document);
/// Channels name samplers of their animation.
[[nodiscard]] std::optional<base::Error> check_samplers(const json::Json& vetted);

}  // namespace penpose::io
