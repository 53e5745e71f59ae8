#include "ui/app/playback/pose_clipboard.h"

#include <algorithm>
#include <cmath>

#include "core/poses/sides.h"

namespace penpose::app {

PoseClipboard copied_pose(const document::Document& document, double time_s) {
  PoseClipboard clipboard;
  const auto parameters = document.model->rig->parameters();
  for (std::size_t i = 0; i < parameters.size(); ++i)
    clipboard.values.push_back({parameters[i].name, document.pose[i]});
  for (const auto& key : document.timeline->keys) {
    if (std::abs(key.time_s - time_s) < 1e-4) clipboard.name = key.name;
  }
  return clipboard;
}

document::SetParameters pasted_values(const document::Document& document, const PoseClipboard& clipboard) {
  document::SetParameters command;
  const auto parameters = document.model->rig->parameters();
  for (const auto& [name, value] : clipboard.values) {
    const auto index = rig::find_parameter(parameters, name);
    if (!index) continue;
    const double fitted = std::clamp(value, parameters[*index].minimum, parameters[*index].maximum);
    if (fitted != document.pose[*index]) command.values.push_back({name, fitted});
  }
  return command;
}

PoseClipboard mirrored(const document::Document& document, const PoseClipboard& clipboard) {
  return {poses::shared_values(*document.model, document.pose, clipboard.values, {.mirrored = true}), clipboard.name};
}

void paste_pose(EditingSession& editing, const PoseClipboard& clipboard, double time_s) {
  const auto values = pasted_values(editing.document(), clipboard);
  const document::SetKey key{time_s, clipboard.name};
  if (values.values.empty()) {
    editing.perform(key);
  } else if (editing.perform(values)) {
    editing.perform_with(key);
  }
}

}  // namespace penpose::app
