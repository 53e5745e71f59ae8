#include <algorithm>
#include <optional>

#include "core/base/text/letters.h"
#include "ui/app/dialogs/dialogs.h"
#include "ui/app/dialogs/entries.h"
#include "ui/app/panels/panels.h"
#include "ui/app/preferences.h"
#include "ui/app/widgets/internal/icon.h"
#include "ui/app/widgets/internal/widgets.h"

// Which key does what: every action with its two keys, which are touched to be given another one.

namespace penpose::app {
namespace {

constexpr float k_keyboard_dialog_wide = 19;
constexpr float k_key_wide = 3.6F;

/// Which key is being chosen, and which one waits for a yes because another action has it.
struct KeyChoice {
  std::optional<Action> action;
  std::size_t place = 0;
  std::optional<KeyStroke> wanted;  ///< in use elsewhere
  bool resets = false;              ///< its own keys are wanted, of which others have some
};

/// What is shown and changed here.
struct KeyboardDialogOwners {
  Preferences& preferences;
  Dialogs& dialogs;
};

KeyMap& keys_of(const KeyboardDialogOwners& with) { return with.preferences.settings().keys; }

void stop_asking(const KeyboardDialogOwners& with) {
  with.dialogs.state<KeyAsked>().waits = false;
  with.dialogs.state<KeyChoice>() = {};
}

void ask(const KeyboardDialogOwners& with, Action action, std::size_t place) {
  with.dialogs.state<KeyChoice>() = {action, place, {}, false};
  with.dialogs.state<KeyAsked>() = {true, {}, -1};
}

void set(const KeyboardDialogOwners& with, const KeyStroke& key) {
  const KeyChoice& choice = with.dialogs.state<KeyChoice>();
  keys_of(with).set(*choice.action, choice.place, key);
  with.preferences.changed();
  stop_asking(with);
}

/// Another action that has one of an action's own keys; null: they are free.
const ActionInfo* has_own_key_of(const KeyMap& keys, Action action) {
  for (const KeyStroke& key : {info(action).key, info(action).other}) {
    const ActionInfo* has = key.key == 0 ? nullptr : keys.action_of(key);
    if (has != nullptr && has->action != action) return has;
  }
  return nullptr;
}

void reset(const KeyboardDialogOwners& with, Action action) {
  keys_of(with).reset(action);
  with.preferences.changed();
  stop_asking(with);
}

/// Takes the key that was pressed for the one that is being chosen.
void take_pressed(const KeyboardDialogOwners& with) {
  KeyChoice& choice = with.dialogs.state<KeyChoice>();
  KeyAsked& asked = with.dialogs.state<KeyAsked>();
  const KeyStroke key = std::exchange(asked.pressed, {});
  if (!choice.action || key.key == 0) return;
  if (key == plain_key(k_key_delete)) return set(with, {});
  if (is_reserved(key)) return stop_asking(with);
  const ActionInfo* has = keys_of(with).action_of(key);
  if (has == nullptr || has->action == *choice.action) return set(with, key);
  if (KeyMap::fixed(has->action)) return stop_asking(with);
  choice.wanted = key;
}

bool fits(const KeyMap& keys, const ActionInfo& one, const std::string& searched) {
  std::string words = std::string(one.label) + " " + std::string(one.tip);
  for (const KeyStroke& key : keys.keys_of(one.action)) words.append(" ").append(shortcut_text(key));
  return base::lower_case(words).find(base::lower_case(searched)) != std::string::npos;
}

void show_row(PanelContext& context, const KeyboardDialogOwners& with, const ActionInfo& one) {
  const KeyMap& keys = keys_of(with);
  const KeyChoice choice = with.dialogs.state<KeyChoice>();
  const bool chosen = choice.action == one.action;
  const float key_px = k_key_wide * context.unit;
  const float spacing = ImGui::GetStyle().ItemSpacing.x;
  const std::string name(one.action.name);
  const auto mine = keys.keys_of(one.action);
  ButtonLook look{ImGui::GetContentRegionAvail().x - 2 * (key_px + spacing), chosen, nullptr, one.icon};
  look.left_aligned = true;
  const std::string tip = std::string(one.tip) + (keys.changed(one.action) ? ". Its keys are not its own" : "");
  look.tip = tip.c_str();
  const std::string shown = std::string(one.label) + (keys.changed(one.action) ? " *" : "") + "##keys " + name;
  ImGui::BeginDisabled(KeyMap::fixed(one.action));
  if (icon_button(context, shown.c_str(), look)) ask(with, one.action, 0);
  for (std::size_t place = 0; place < mine.size(); ++place) {
    ImGui::SameLine();
    const bool asked = chosen && choice.place == place;
    const std::string text = asked && !choice.wanted ? "press" : shortcut_text(mine[place]);
    const std::string id = text + "###key " + std::to_string(place) + " " + name;
    if (wide_button(context, id.c_str(), key_px, asked, "Touch it, then press another key"))
      ask(with, one.action, place);
  }
  ImGui::EndDisabled();
}

/// What is being asked, and the answers for a pen.
void show_question(PanelContext& context, const KeyboardDialogOwners& with) {
  const KeyChoice choice = with.dialogs.state<KeyChoice>();
  KeyMap& keys = keys_of(with);
  const std::string label(choice.action ? info(*choice.action).label : std::string_view());
  const ActionInfo* has = choice.wanted                    ? keys.action_of(*choice.wanted)
                          : choice.resets && choice.action ? has_own_key_of(keys, *choice.action)
                                                           : nullptr;
  if (has != nullptr) {
    const std::string key = choice.wanted ? shortcut_text(*choice.wanted) : "A key of its own";
    ImGui::TextWrapped("%s is the key of %s.", key.c_str(), std::string(has->label).c_str());
    if (wide_button(context, ("Take it for " + label + "###take over").c_str())) {
      if (choice.wanted) {
        set(with, *choice.wanted);
      } else {
        reset(with, *choice.action);
      }
    }
    ImGui::SameLine();
    if (wide_button(context, "Leave it##key")) stop_asking(with);
    return;
  }
  if (!choice.action) {
    ImGui::TextWrapped("Touch a key, then press the one that it shall be.");
    // Not where the answers to a question are, which may be touched twice.
    const float wide = button_width(context, "All as they were", {}, true);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - wide);
    if (wide_button(context, "All as they were##key", 0, false, "Every action has its own keys again") &&
        keys.any_changed()) {
      keys.reset_all();
      with.preferences.changed();
    }
    return;
  }
  ImGui::TextWrapped("Press a key for %s. Esc: leave it; Del: none.", label.c_str());
  if (wide_button(context, "None##key", 0, false, "No key here")) return set(with, {});
  ImGui::SameLine();
  ImGui::BeginDisabled(!keys.changed(*choice.action));
  if (wide_button(context, "Reset##key", 0, false, "Its own keys again")) {
    with.dialogs.state<KeyAsked>().waits = false;
    if (has_own_key_of(keys, *choice.action) == nullptr) {
      reset(with, *choice.action);
    } else {
      with.dialogs.state<KeyChoice>().resets = true;
    }
  }
  ImGui::EndDisabled();
  ImGui::SameLine();
  if (wide_button(context, "Leave it##key")) stop_asking(with);
}

}  // namespace

void show_keyboard_dialog(PanelContext& context, Preferences& preferences, Dialogs& dialogs) {
  const KeyboardDialogOwners with{preferences, dialogs};
  if (context.dialog_opens) stop_asking(with);
  take_pressed(with);
  // Escape leaves the question first.
  if (context.cancels && dialogs.state<KeyChoice>().action) {
    stop_asking(with);
    context.cancels = false;
  }
  if (begin_dialog(context, "Keys of the keyboard", k_keyboard_dialog_wide)) {
    std::string& searched = dialogs.state<SearchEntry>().text;
    // While a key is waited for nothing takes the keyboard.
    if (dialogs.state<KeyChoice>().action) context.field_first = false;
    dialog_field(context, "##key search", searched, "search: an action or a key");
    const float below = 2 * context.unit + 2 * ImGui::GetTextLineHeight() + 4 * ImGui::GetStyle().ItemSpacing.y;
    const float room = static_cast<float>(context.window.height) - 2.5F * context.unit - below;
    begin_list(context, "keys", {0, std::clamp(room, 2 * context.unit, 9 * context.unit)}, true);
    for (const ActionInfo& one : all_actions()) {
      if (fits(keys_of(with), one, searched)) show_row(context, with, one);
    }
    ImGui::EndChild();
    show_question(context, with);
    if (primary_button(context, "Done##keyboard") || context.accepts) dialogs.show(Dialog::none);
  }
  end_dialog();
}

}  // namespace penpose::app
