#include "core/poses/face_part.h"

#include <array>
#include <utility>

namespace penpose::poses {
namespace {

constexpr std::array<std::string_view, 4> k_names{"all", "brows", "eyes", "mouth"};

}  // namespace

std::optional<FacePart> part_of_feature(std::string_view feature) {
  const auto has = [&](std::string_view word) { return feature.find(word) != std::string_view::npos; };
  if (has("brow")) return FacePart::brows;
  if (has("lid") || has("eye")) return FacePart::eyes;
  if (has("lip") || has("mouth") || has("jaw")) return FacePart::mouth;
  return std::nullopt;
}

std::string_view name_of(FacePart part) { return k_names[static_cast<std::size_t>(part)]; }

std::optional<FacePart> part_named(std::string_view name) {
  for (std::size_t i = 0; i < k_names.size(); ++i) {
    if (k_names[i] == name) return static_cast<FacePart>(i);
  }
  return std::nullopt;
}

}  // namespace penpose::poses
