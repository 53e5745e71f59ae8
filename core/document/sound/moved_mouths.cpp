#include "core/document/sound/moved_mouths.h"

#include <algorithm>
#include <utility>

#include "core/document/time/timeline_editing.h"

namespace penpose::document {
namespace {

bool has_all(const std::vector<std::size_t>& controls, const std::vector<std::size_t>& wanted) {
  return std::all_of(wanted.begin(), wanted.end(), [&](std::size_t one) {
    return std::find(controls.begin(), controls.end(), one) != controls.end();
  });
}

}  // namespace

std::shared_ptr<const SpokenMouths> with_moved_keys(const Document& document, std::span<const KeysMoved> moved,
                                                    bool copies) {
  if (!document.spoken) return nullptr;
  const auto controls = controls_of(document.mouths, *document.spoken, document.model->rig->parameters());
  SpokenMouths stay;
  SpokenMouths arrive;
  for (const SpokenMouth& one : *document.spoken) {
    const auto place = key_at(*document.timeline, one.time_s);
    const auto goes =
        std::find_if(moved.begin(), moved.end(), [&](const KeysMoved& keys) { return place && keys.place == *place; });
    const bool whole = goes != moved.end() && has_all(goes->controls, controls);
    if (whole) arrive.push_back({goes->to_s, one.mouth});
    if (!whole || copies) stay.push_back(one);
  }
  if (arrive.empty()) return document.spoken;
  // Of two at a moment the one that arrived counts.
  stay.insert(stay.end(), arrive.begin(), arrive.end());
  std::stable_sort(stay.begin(), stay.end(),
                   [](const SpokenMouth& a, const SpokenMouth& b) { return a.time_s < b.time_s; });
  SpokenMouths out;
  for (SpokenMouth& one : stay) {
    if (!out.empty() && out.back().time_s == one.time_s) out.pop_back();
    out.push_back(std::move(one));
  }
  return std::make_shared<const SpokenMouths>(std::move(out));
}

}  // namespace penpose::document
