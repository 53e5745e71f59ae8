#pragma once

#include <cstdint>

namespace penpose::base {

/// What a stroke and a command mean. Each session and each project says under which edition it was drawn. A session of
/// an older one is drawn again by today where that is asked for, and of an older project the controls are read that are
/// built alike today (docs/sessions.md). A change of behaviour raises the number and renews the golden hashes.
inline constexpr std::uint32_t k_edition = 7;

}  // namespace penpose::base
