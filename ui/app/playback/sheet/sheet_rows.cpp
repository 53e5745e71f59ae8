#include "ui/app/playback/sheet/sheet_rows.h"

#include <algorithm>
#include <array>
#include <utility>

namespace penpose::app {

std::vector<SheetRow> sheet_rows(const document::Document& document, std::span<const FacePart> parts,
                                 const std::set<std::string>& folded, bool all) {
  const auto parameters = document.model->rig->parameters();
  const auto& keys = document.timeline->keys;
  const auto listed = [&](std::size_t control) {
    return std::any_of(keys.begin(), keys.end(), [&](const document::PoseKey& key) {
      return key.controls.has(control) && (all || key.pose[control] != parameters[control].rest);
    });
  };
  constexpr std::array<std::pair<FacePart, const char*>, 4> k_groups{
      {{FacePart::brows, "Brows"}, {FacePart::eyes, "Eyes"}, {FacePart::mouth, "Mouth"}, {FacePart::all, "Others"}}};
  std::vector<SheetRow> rows;
  for (const auto& [part, name] : k_groups) {
    SheetRow group{name, true, folded.count(name) > 0, {}};
    for (std::size_t i = 0; i < parameters.size() && i < parts.size(); ++i) {
      if (parts[i] == part && listed(i)) group.controls.push_back(i);
    }
    if (group.controls.empty()) continue;
    rows.push_back(group);
    if (group.folded) continue;
    for (const std::size_t control : group.controls)
      rows.push_back({parameters[control].name, false, false, {control}});
  }
  return rows;
}

}  // namespace penpose::app
