#pragma once

#include "core/base/json/json.h"
#include "core/base/result.h"
#include "core/document/document.h"

namespace penpose::io {

/// What a project has beyond its model, the member "project" of the root's extras:
///
/// {"curves": [{"id", "role": "reference"|"constraint", "points": [[triangle, b0, b1, b2], ...], "kept": [[x, y, z],
/// ...], "time_s", "target": {"view", "line": [[x, y, pressure], ...], "points": [[x, y, z, weight], ...]}}],
/// "last_curve", "locked": [name, ...], "pressure_weighting", "hand", "pending": [command, ...], "time_s", "timeline":
/// {"keys": [{"time_s", "pose": [value, ...], "name" (if it has one), "controls": [[parameter, kind, in, out], ...]
/// (those that have a key, in, out only where the kind is "free" or "overshoot"; where all are smooth there is no
/// list)}]}, what
/// project_view.h says, "sound": {"file", "content", "offset_s"}, "mouths": [{"name", "values": {control: value}}],
/// "spoken": [{"time_s", "mouth"}], "words": [{"from_s", "word"}], "bookmarks": [{"time_s", "name", "color"}]}, the
/// last five if there are any. Views and commands are written as core/document/commands/command_text.h says; "pose" is
/// in the order of the model's parameters.
[[nodiscard]] json::Json project_to_json(const document::Document& document);

/// The document of a project file from its model and the member "project" at `pointer`. Errors (place: JSON pointer): a
/// member that is missing or of another type, a curve that is not on the mesh, poses that do not fit the model.
[[nodiscard]] base::Result<document::Document> read_project(const json::Json& project, const std::string& pointer,
                                                            document::Model model);

}  // namespace penpose::io
