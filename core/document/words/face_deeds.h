#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/words/face_effect.h"

namespace penpose::document {

/// A thing that faces do and people have words for, by its number.
using Deed = std::size_t;

/// "smile", "eye closes".
[[nodiscard]] std::string_view words_of_deed(Deed deed, bool both);
/// The deed of these words for one side; none: there is none.
[[nodiscard]] std::optional<Deed> deed_of_words(std::string_view one);

/// A deed and how much an effect is like it, -1..1.
struct LikeDeed {
  Deed deed = 0;
  double alike = 0;
};

/// All deeds that an effect may be, the likest first.
[[nodiscard]] std::vector<LikeDeed> deeds_like(const Aspects& aspects, FaceSide side);
/// What is left of an effect without a deed.
[[nodiscard]] Aspects without(const Aspects& aspects, Deed deed);
/// "jaw left", "mouth right", "mouth tilts, left up", "eyes look left"; empty where an effect does not go to one side.
[[nodiscard]] std::string words_sideways(const FaceEffect& effect);

/// The deed that a control's name says as programs of animation agree on it (ARKit, FACS, VRM); none: it says none.
[[nodiscard]] std::optional<Deed> deed_named(std::string_view control);
/// What else a name is known for: a sound that the mouth makes ("mouth: aa") or a feeling ("joy"); empty: nothing.
[[nodiscard]] std::string expression_named(std::string_view control);

}  // namespace penpose::document
