#pragma once

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

}  // namespace penpose::files
