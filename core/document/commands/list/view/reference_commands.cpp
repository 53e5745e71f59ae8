#include "core/document/commands/list/view/reference_commands.h"

#include <cmath>
#include <memory>
#include <optional>

#include "core/document/commands/apply_parts.h"
#include "core/document/time/timeline.h"

namespace penpose::document {
namespace {

/// Cards reach no farther out of the window than this, in shares of it.
constexpr double k_farthest_card = 1;

std::optional<base::Error> check_place(const ReferencePicture& picture) {
  const auto within = [](double value, double least, double most) { return value >= least && value <= most; };
  if (!within(picture.offset_s, -k_latest_key_s, k_latest_key_s))
    return base::Error{"the reference would begin beyond the timeline", "offset_s",
                       "give seconds from -36000 to 36000"};
  if (!within(picture.opacity, 0, 1)) return base::Error{"the opacity is out of range", "opacity", "give 0 to 1"};
  if (!(picture.height > 0)) return base::Error{"the reference has no height", "height", "give one above 0"};
  if (!within(picture.card_height, k_smallest_card, k_largest_card))
    return base::Error{"the card is too small or too large", "card_height", "give 0.05 to 1"};
  if (!within(picture.card.x, -k_farthest_card, k_farthest_card) ||
      !within(picture.card.y, -k_farthest_card, k_farthest_card))
    return base::Error{"the card lies outside of the window", "card", "give shares from -1 to 1"};
  return std::nullopt;
}

}  // namespace

Changed run(const Document& document, const SetReference& command, Parts&) {
  const ReferencePicture& picture = command.picture;
  if (picture.file.empty() || picture.file.size() > k_longest_reference_path)
    return base::Error{"the name of a file was expected", "file", "name a picture or a film of at most 4096 bytes"};
  if (auto error = check_place(picture)) return *error;
  Document changed = document;
  changed.reference = std::make_shared<const ReferencePicture>(picture);
  return changed;
}

Changed run(const Document& document, const RemoveReference&, Parts&) {
  if (!document.reference) return base::Error{"there is no reference", "", "place one first"};
  Document changed = document;
  changed.reference = nullptr;
  return changed;
}

}  // namespace penpose::document
