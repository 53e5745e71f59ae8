#pragma once

#include <array>
#include <string_view>

#include "core/document/sound/mouths.h"
#include "core/phonetics/nine_mouths.h"

namespace penpose::app {

/// What is said of one of the nine mouths to somebody who draws it for the first time.
struct MouthSlot {
  speech::NineMouth mouth = speech::NineMouth::rest;
  std::string_view sounds;  ///< "m, b, p"
  std::string_view looks;   ///< "lips pressed together"

  [[nodiscard]] std::string_view name() const { return speech::name_of(mouth); }
};

/// In the order in which they are best drawn: speech can be read with the first k_first_mouths of them.
extern const std::array<MouthSlot, speech::k_nine> k_mouth_slots;
inline constexpr std::size_t k_first_mouths = 6;

/// The one that is best drawn next; null: all are kept.
[[nodiscard]] const MouthSlot* next_slot(const document::Mouths& mouths);

}  // namespace penpose::app
