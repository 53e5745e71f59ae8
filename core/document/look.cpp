#include "core/document/look.h"

namespace penpose::document {

std::string undrawn_note(std::span<const std::string> undrawn) {
  constexpr std::size_t k_named = 3;
  if (undrawn.empty()) return {};
  const std::size_t count = undrawn.size();
  std::string text = count == 1 ? "1 texture cannot be drawn and is grey: "
                                : std::to_string(count) + " textures cannot be drawn and are grey: ";
  for (std::size_t i = 0; i < count && i < k_named; ++i) text += (i > 0 ? ", " : "") + undrawn[i];
  if (count > k_named) text += ", and " + std::to_string(count - k_named) + " more";
  return text;
}

}  // namespace penpose::document
