#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "core/base/json/json.h"
#include "core/base/result.h"
#include "core/document/model.h"

namespace penpose::io {

/// Reads {"name", "points": [[triangle, b0, b1, b2], ...]}. Errors (place: JSON pointer): a member that is missing or
/// of another form.
[[nodiscard]] std::optional<base::Error> read_named_curve(const json::Json& value, const std::string& pointer,
                                                          const char* remedy, document::NamedCurve& out);
/// Errors (place: JSON pointer below that of their list): a point that is not on a mesh of so many triangles.
[[nodiscard]] std::optional<base::Error> check_named_curves(std::span<const document::NamedCurve> curves,
                                                            std::size_t triangle_count, const std::string& pointer,
                                                            const char* remedy);
[[nodiscard]] json::Json to_json(std::span<const document::NamedCurve> curves);

}  // namespace penpose::io
