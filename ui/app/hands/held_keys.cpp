#include "ui/app/hands/held_keys.h"

#include "ui/app/dialogs/entries.h"

namespace penpose::app {

namespace {

using Kind = Binding::Kind;

}  // namespace

const ViewHold* HeldKeys::held_view() const {
  const Binding* held = parts_.desk.held(Kind::view);
  return held == nullptr ? nullptr : &held->view;
}

void HeldKeys::place_pen() {
  if (parts_.editing.pen_is_drawing()) return;
  parts_.editing.input().place_pen(parts_.hits.on_canvas(parts_.place.at()) && held_view() == nullptr);
}

void HeldKeys::follow_tool() {
  EditingSession& editing = parts_.editing;
  const Binding* held = parts_.desk.held(Kind::tool);
  auto wanted = held != nullptr ? std::optional(held->tool) : std::nullopt;
  // While all features are shown, what Pose draws first is where one of them is.
  if (wanted == drawing::ToolKind::pose && parts_.features.shown()) wanted = drawing::ToolKind::feature;
  // A stroke ends as what it began.
  if (wanted == tool_held_ || editing.pen_is_drawing()) return;
  if (wanted) {
    if (!tool_before_) tool_before_ = editing.editor().tool();
    drawing::Tool tool;
    tool.kind = *wanted;
    editing.set_tool(tool);
  } else if (tool_before_) {
    // Somebody who chose another tool meanwhile keeps it.
    if (editing.editor().tool().kind == *tool_held_) editing.set_tool(*tool_before_);
    tool_before_.reset();
  }
  tool_held_ = wanted;
}

void HeldKeys::press(DeskTablet& tablet, int device, const PadControl& control) {
  const Dialog dialog = parts_.dialogs.open();
  if (dialog == Dialog::pad) {
    // Whoever presses a key there means to choose for it.
    parts_.dialogs.state<PadChoice>().tablet = {tablet.key, tablet.unit};
    parts_.dialogs.state<PadChoice>().control = control;
    return;
  }
  const Binding binding = parts_.bindings.bound(tablet, control);
  const bool open = !parts_.hits.all && dialog == Dialog::none;
  switch (binding.kind) {
    case Kind::none:
    case Kind::dial:
    case Kind::pen_menu:
      break;
    case Kind::action:
      if (open || binding.action == Action::cancel) parts_.actions.run(binding.action);
      break;
    case Kind::view:
    case Kind::tool:
      parts_.desk.press({device, control, binding});
      place_pen();
      follow_tool();
      break;
    case Kind::next_mode:
      for (std::int8_t& mode : tablet.next_mode)
        mode = static_cast<std::int8_t>((mode + 1) % modes_of(tablet.features));
      parts_.notices.tell(
          "Ring, strip and wheel: " +
          label_of(parts_.bindings.bound(tablet, dial_control(decode::PadDial::ring, 0, tablet.next_mode[0]))));
      break;
  }
}

void HeldKeys::let_go(int device, const PadControl& control) {
  if (!parts_.desk.release(device, control)) return;
  place_pen();
  follow_tool();
}

void HeldKeys::forget() {
  tool_before_.reset();
  tool_held_.reset();
}

}  // namespace penpose::app
