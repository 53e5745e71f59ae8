#pragma once

#include <string>
#include <string_view>

#include "core/document/words/face_effect.h"

namespace penpose::document {

/// A name in small words, its side apart: "mouth_corner_L" is "mouth corner" and left.
struct ReadableName {
  std::string what;  ///< the name itself where nothing of it is left
  FaceSide side = FaceSide::both;

  /// "mouth corner, left".
  [[nodiscard]] std::string text() const { return what + std::string(behind(side)); }
};
[[nodiscard]] ReadableName readable_name(std::string_view name);

}  // namespace penpose::document
