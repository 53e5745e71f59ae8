#include <algorithm>

#include "ui/app/dialogs/dialogs.h"
#include "ui/app/dialogs/entries.h"
#include "ui/app/hands/bindings.h"
#include "ui/app/hands/hand_desk.h"
#include "ui/app/panels/panels.h"
#include "ui/app/preferences.h"
#include "ui/app/widgets/internal/widgets.h"
#include "ui/app/widgets/pad_picture.h"

// What the keys, dials and pens of tablets do, chosen with the pen alone.

namespace penpose::app {
namespace {

/// The tablet that is shown: the one that was chosen, else the first with keys, else the first; null: none.
const DeskTablet* shown_tablet(const PadOwners& with, std::span<const DeskTablet> tablets) {
  const auto first = [&](auto fits) -> const DeskTablet* {
    const auto found = std::find_if(tablets.begin(), tablets.end(), fits);
    return found == tablets.end() ? nullptr : &*found;
  };
  if (const auto* chosen = first(
          [&](const DeskTablet& one) { return one.is(with.dialogs.state<PadChoice>().tablet) && one.has_anything(); }))
    return chosen;
  if (const auto* keys = first([](const DeskTablet& one) { return one.features.any(); })) return keys;
  return first([](const DeskTablet& one) { return one.has_anything(); });
}

/// Whether the tablet has it: another one may be shown than a moment ago.
bool has(const DeskTablet& tablet, const PadControl& control) {
  switch (control.kind) {
    case PadControl::Kind::key:
      return tablet.features.keys.has(static_cast<decode::PadKey>(control.index));
    case PadControl::Kind::ring:
      return control.index < tablet.features.rings;
    case PadControl::Kind::strip:
      return control.index < tablet.features.strips;
    case PadControl::Kind::wheel:
      return control.index < tablet.features.wheels;
    case PadControl::Kind::pen_button:
      return tablet.has_pen;
    case PadControl::Kind::pen_wheel:
      return tablet.pen_wheel;
    case PadControl::Kind::pen_rotation:
      return tablet.pen_rotation;
  }
  return false;
}

void show_tablets(PanelContext& context, const PadOwners& with, std::span<const DeskTablet> tablets,
                  const DeskTablet& shown) {
  const auto count =
      std::count_if(tablets.begin(), tablets.end(), [](const DeskTablet& one) { return one.has_anything(); });
  if (count > 1) {
    for (const DeskTablet& one : tablets) {
      if (!one.has_anything()) continue;
      if (wide_button(context, (one.name + "##tablet " + one.key + " " + one.unit).c_str(), 0, &one == &shown))
        with.dialogs.state<PadChoice>().tablet = {one.key, one.unit};
      ImGui::SameLine();
    }
    ImGui::NewLine();
  }
  std::string text = shown.name;
  // 0 comes before it has been measured.
  if (shown.battery.percent > 0) {
    text += "   battery " + std::to_string(shown.battery.percent) + " %";
    if (shown.battery.charging) text += ", charging";
  }
  ImGui::TextUnformatted(text.c_str());
  show_guess(context, shown);
  ImGui::TextDisabled("Touch a key here or press it on the tablet, then what it should do.");
}

class Choices {
 public:
  Choices(PanelContext& context, const PadOwners& with, const DeskTablet& tablet)
      : context_(context), with_(with), tablet_(tablet), control_(with.dialogs.state<PadChoice>().control) {}

  void show();

 private:
  void choice(const Binding& binding);

  PanelContext& context_;
  PadOwners with_;
  const DeskTablet& tablet_;
  PadControl control_;
  int column_ = 0;
};

void Choices::choice(const Binding& binding) {
  if (column_++ % 2 != 0) ImGui::SameLine();
  const float half = 0.5F * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
  const float width = column_ % 2 != 0 ? half : -1;
  const std::string text = to_text(binding);
  const std::string tip = tip_of(binding);
  const bool is = with_.bindings.bound(tablet_, control_) == binding;
  if (wide_button(context_, (label_of(binding) + "##choose " + text).c_str(), width, is, tip.c_str())) {
    with_.bindings.bind(tablet_, control_,
                        binding == default_binding(control_, tablet_.features) ? std::nullopt : std::optional(binding));
  }
  note(context_, ("choose " + text).c_str());
}

void Choices::show() {
  ImGui::TextUnformatted(title_of(control_, tablet_.features).c_str());
  bool once = with_.dialogs.state<PadChoice>().once;
  if (!is_dial(control_)) {
    const float half = 0.5F * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
    if (wide_button(context_, "While held", half, !once)) with_.dialogs.state<PadChoice>().once = once = false;
    ImGui::SameLine();
    if (wide_button(context_, "Once", -1, once)) with_.dialogs.state<PadChoice>().once = once = true;
  }
  begin_list(context_, "choices", {0, 0}, true);
  choice({});
  if (is_dial(control_)) {
    for (const Binding& one : dial_choices()) choice(one);
  } else if (once) {
    for (const ActionInfo& one : all_actions()) choice(binding_of(one.action));
  } else {
    for (const Binding& one : held_choices()) choice(one);
    Binding other;
    other.kind = control_.kind == PadControl::Kind::pen_button ? Binding::Kind::pen_menu : Binding::Kind::next_mode;
    const bool dials = tablet_.features.rings + tablet_.features.strips + tablet_.features.wheels > 0;
    if (other.kind == Binding::Kind::pen_menu || (dials && tablet_.features.modes == 0)) choice(other);
  }
  ImGui::EndChild();
}

/// Whoever goes to another key sees what it does now among what is offered.
void follow_control(const PadOwners& with, const DeskTablet& tablet) {
  const PadControl& control = with.dialogs.state<PadChoice>().control;
  const int now = 1 + static_cast<int>(control.kind) * 65536 + control.index * 256 + control.mode;
  ImGuiStorage& kept = *ImGui::GetStateStorage();
  const ImGuiID place = ImGui::GetID("control that was shown");
  if (kept.GetInt(place) == now) return;
  kept.SetInt(place, now);
  with.dialogs.state<PadChoice>().once = with.bindings.bound(tablet, control).kind == Binding::Kind::action;
}

}  // namespace

void show_pad_dialog(PanelContext& context, EditingSession& editing, HandDesk& desk, Bindings& bindings,
                     Preferences& preferences, Dialogs& dialogs) {
  const PadOwners with{editing, desk, bindings, dialogs};
  if (begin_dialog(context, "Keys of the tablet###keys of the tablet", 23)) {
    const auto& tablets = desk.tablets();
    const DeskTablet* tablet = shown_tablet(with, tablets);
    if (tablet == nullptr) {
      ImGui::TextWrapped("No tablet is plugged in. When one is, its keys, rings, strips and its pen are shown here.");
    } else {
      PadControl& control = dialogs.state<PadChoice>().control;
      const auto keys = keys_of(tablet->features);
      if (!has(*tablet, control)) control = keys.empty() ? pen_button_control(0) : key_control(keys.front());
      follow_control(with, *tablet);
      show_tablets(context, with, tablets, *tablet);
      // As high as it is, up to what the window has room for.
      const float room = static_cast<float>(context.window.height) - 6 * context.unit;
      const float least = 5 * context.unit;
      const float height = std::clamp(dialogs.state<PadChoice>().height, std::min(2 * least, std::max(room, least)),
                                      std::max(room, least));
      begin_list(context, "pad", {10.6F * context.unit, height}, false);
      ImGui::BeginGroup();
      show_pad_picture(context, with, *tablet);
      ImGui::EndGroup();
      dialogs.state<PadChoice>().height = ImGui::GetItemRectSize().y + context.gap;
      ImGui::EndChild();
      ImGui::SameLine();
      begin_list(context, "chosen", {0, height}, false);
      Choices(context, with, *tablet).show();
      ImGui::EndChild();
      if (wide_button(context, "Reset##pad") && preferences.settings().pads.erase(tablet->key) > 0)
        preferences.changed();
      ImGui::SameLine();
    }
    if (primary_button(context, "Done") || context.accepts) dialogs.show(Dialog::none);
  }
  end_dialog();
}

}  // namespace penpose::app
