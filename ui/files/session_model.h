#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace penpose::files {

/// What a plain trace is drawn on.
inline constexpr const char* k_default_model = "builtin:demo";

/// Where a copy of the model that a session began on is kept, once the model's own file is written over.
[[nodiscard]] std::string kept_model_of(const std::string& session, const std::string& model);

/// The file to replay a session on that names `model` (empty: none): the copy that was kept of it, itself, or one of
/// its name beside the session; `model` where there is none of these. `model` and the answer may say how the file's
/// coordinates are meant (ModelName).
[[nodiscard]] std::string find_session_model(const std::string& session, const std::string& model);

/// Whether a model, as find_session_model gives it, may be in another state today than when a session of an older
/// edition began on it: the program's own, and projects of older editions, whose controls are built anew.
[[nodiscard]] bool changes_with_editions(const std::string& model);

/// The edition under which a session was recorded, where that is older than this program's. Nothing for any other file.
[[nodiscard]] std::optional<std::uint32_t> older_edition_of(const std::string& session);

}  // namespace penpose::files
