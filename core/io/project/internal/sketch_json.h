#pragma once

#include <optional>
#include <string>

#include "core/articulation/corrections.h"
#include "core/base/json/json.h"
#include "core/base/result.h"

namespace penpose::io {

/// No rig needs more; the bound keeps what a small file can ask for small.
inline constexpr std::size_t k_most_deformers = 1000;
/// Each is built on what the ones before it made.
inline constexpr std::size_t k_most_corrections = 100;

/// Reads one deformer of a sketch file into `out`; the error, or nothing. `viewport` is that of the file; a member
/// "viewport" of the deformer counts before it. Errors (place: JSON pointer): a key that is missing or of another type,
/// and those of articulation::check_sketch.
[[nodiscard]] std::optional<base::Error> read_sketch(const json::Json& value, const std::string& pointer,
                                                     std::optional<geometry::Viewport> viewport,
                                                     articulation::Sketch& out);
[[nodiscard]] std::optional<base::Error> read_viewport(const json::Json& object, const std::string& pointer,
                                                       std::optional<geometry::Viewport>& out);

/// Whether deformers carry their viewport or leave it to the file.
enum class Viewports : std::uint8_t { shared, each };
[[nodiscard]] json::Json to_json(const articulation::Sketch& sketch, Viewports viewports);
[[nodiscard]] json::Json to_json(const geometry::Viewport& viewport);

/// "drivers" of a correction: [[CONTROL, VALUE], ...]. Errors (place: JSON pointer): missing, another form, too few or
/// too many.
[[nodiscard]] std::optional<base::Error> read_drivers(const json::Json& value, const std::string& pointer,
                                                      std::vector<articulation::Driver>& out);
[[nodiscard]] json::Json to_json(const articulation::CorrectionSketch& correction, Viewports viewports);

}  // namespace penpose::io
