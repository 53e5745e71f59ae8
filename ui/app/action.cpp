#include "ui/app/action.h"

#include "ui/app/actions.h"
#include "ui/app/app.h"
#include "ui/app/tools/tool_in_hand.h"

namespace penpose::app {
const ActionInfo& info(Action action) {
  for (const ActionInfo& one : all_actions()) {
    if (one.action == action) return one;
  }
  return all_actions().front();
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
  if (const ActionInfo* one = keys().action_of(key); one != nullptr) run(one->action);
}

const KeyMap& Actions::keys() const { return app_.of<Preferences>().settings().keys; }

bool Actions::usable(Action action) const {
  const ActionInfo& one = info(action);
  return one.usable == nullptr || one.usable(app_);
}

}  // namespace penpose::app
