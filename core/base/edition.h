#pragma once

#include <cstdint>

namespace penpose::base {

/// What a stroke and a command mean. Each session and each project says under which edition it was drawn; of another
/// edition a session is refused, and a project opens with its baked targets. A change of behaviour raises the number
/// and renews the golden hashes (docs/sessions.md).
inline constexpr std::uint32_t k_edition = 7;

}  // namespace penpose::base
