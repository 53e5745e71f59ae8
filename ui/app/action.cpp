#include "ui/app/action.h"

#include "core/base/text/letters.h"
#include "ui/app/actions.h"
#include "ui/app/app.h"
#include "ui/app/tools/tool_in_hand.h"

namespace penpose::app {
namespace {

std::string key_name(std::uint32_t key) {
  switch (key) {
    case k_key_escape:
      return "Esc";
    case k_key_tab:
      return "Tab";
    case k_key_delete:
      return "Del";
    case k_key_home:
      return "Home";
    case k_key_left:
      return "Left";
    case k_key_right:
      return "Right";
    case k_key_up:
      return "Up";
    case k_key_down:
      return "Down";
    case k_key_f1:
      return "F1";
    case k_key_f11:
      return "F11";
    case ' ':
      return "Space";
    default:
      return {base::upper(static_cast<char>(key))};
  }
}

}  // namespace

const ActionInfo& info(Action action) {
  for (const ActionInfo& one : all_actions()) {
    if (one.action == action) return one;
  }
  return all_actions().front();
}

const ActionInfo* action_of(const KeyStroke& pressed) {
  KeyStroke key = pressed;
  // Where + lies on the key of =, as on most keyboards, it is typed with Shift.
  if (key.key == '=' && key.shift) key = {'+', key.ctrl, false};
  for (const ActionInfo& one : all_actions()) {
    if (one.key.key != 0 && (one.key == key || (one.other.key != 0 && one.other == key))) return &one;
  }
  return nullptr;
}

std::string shortcut_text(const KeyStroke& key) {
  if (key.key == 0) return {};
  return std::string(key.ctrl ? "Ctrl+" : "") + (key.shift ? "Shift+" : "") + key_name(key.key);
}

std::string tooltip_of(Action action) {
  const ActionInfo& one = info(action);
  const std::string key = shortcut_text(one.key);
  return std::string(one.tip) + (key.empty() ? "" : " (" + key + ")");
}

void Actions::run(Action action) {
  const ActionInfo& one = info(action);
  if (one.tool != nullptr) {
    app_.of<ToolInHand>().take(*one.tool);
    auto& preferences = app_.of<Preferences>();
    const bool pose = one.tool->kind == drawing::ToolKind::pose;
    if ((pose || one.tool->kind == drawing::ToolKind::draw) && preferences.settings().pose_first != pose) {
      preferences.settings().pose_first = pose;
      preferences.changed();
    }
    return;
  }
  one.run(app_);
}

void Actions::press(const KeyStroke& key) {
  if (const ActionInfo* one = action_of(key); one != nullptr) run(one->action);
}

bool Actions::usable(Action action) const {
  const ActionInfo& one = info(action);
  return one.usable == nullptr || one.usable(app_);
}

}  // namespace penpose::app
