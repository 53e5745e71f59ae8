#pragma once

#include <cstdint>

namespace penpose::base {

/// The edition of how strokes and commands are read. Each session and each project names the edition that wrote it.
/// The program draws an older session again with today's reading, if asked. It opens an older project with the controls
/// that today's reading builds alike (docs/sessions.md). A change of behaviour raises the number and renews the golden
/// hashes.
inline constexpr std::uint32_t k_edition = 11;

}  // namespace penpose::base
