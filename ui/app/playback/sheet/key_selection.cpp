#include "ui/app/playback/sheet/key_selection.h"

#include "core/document/time/timeline_editing.h"

namespace penpose::app {

void KeySelection::keep_known(const document::Document& document) {
  const document::Timeline& timeline = *document.timeline;
  std::erase_if(keys_, [&](const Key& key) {
    const auto place = document::key_at(timeline, key.first);
    return !place || key.second >= document.pose.size() || !timeline.keys[*place].controls.has(key.second);
  });
}

document::OfKeys KeySelection::of(const document::Document& document) const {
  document::OfKeys out;
  const auto parameters = document.model->rig->parameters();
  for (const auto& [time_s, parameter] : keys_) {
    out.times_s.push_back(time_s);
    out.names.push_back(parameters[parameter].name);
  }
  return out;
}

}  // namespace penpose::app
