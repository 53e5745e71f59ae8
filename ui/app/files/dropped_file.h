#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "core/base/byte_reader.h"

namespace penpose::app {

/// What a file is by what is in it; by its name only where its content leaves that open.
enum class DroppedKind : std::uint8_t {
  model,
  project,
  session,  ///< or a trace of a tablet, or a recording of one in another form
  sound,
  picture,
  film,
  drawing,  ///< lines as SVG
  take,     ///< of a tracked face
  unknown,
};

/// What can be done with a file that was dropped on the window.
enum class DropDeed : std::uint8_t {
  open,              ///< in place of what is open, which is asked about
  add_beside,        ///< as another character
  lay_sound,         ///< beside the timeline
  reference_behind,  ///< the model
  reference_beside,  ///< as a card
  read_drawing,      ///< the face takes what it shows
  key_take,          ///< its motion as keys of the timeline
};

/// `head`: the first bytes of a file, k_drop_head of them where it has so many. `name`: of the file.
inline constexpr std::size_t k_drop_head = std::size_t{1} << 16;
[[nodiscard]] DroppedKind kind_of_content(base::Bytes head, std::string_view name);
/// The same of a file on the disk; unknown where it cannot be read.
[[nodiscard]] DroppedKind kind_of_dropped(const std::string& path);

/// "a model", as people say it.
[[nodiscard]] std::string_view words_of(DroppedKind kind);
/// What can be done with it, the usual one first; empty: nothing.
[[nodiscard]] std::span<const DropDeed> deeds_of(DroppedKind kind);

struct DropDeedWords {
  const char* label;
  const char* tip;
};
[[nodiscard]] DropDeedWords words_of(DropDeed deed);

}  // namespace penpose::app
