#pragma once

#include "core/base/json/json.h"
#include "core/document/document.h"
#include "core/io/project/internal/project_values.h"

// The members "timeline" and "clips" of a project.

namespace penpose::io {

[[nodiscard]] json::Json timeline_to_json(const document::Timeline& timeline);
/// Reads it into a document that has its model already; a project without one has no keys.
[[nodiscard]] Problem read_timeline(const json::Json& project, const std::string& pointer, document::Document& out);

/// The document's clips; the one that is shown is without its keys, which are the timeline.
[[nodiscard]] json::Json clips_to_json(const document::Document& document);
/// Reads them, where there are any, into a document that has its model, timeline and mouths already. Their animations
/// are numbers among those that the file has of the model.
[[nodiscard]] Problem read_clips(const json::Json& project, const std::string& pointer, document::Document& out);

}  // namespace penpose::io
