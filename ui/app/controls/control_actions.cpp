#include "ui/app/controls/control_actions.h"

#include <array>

#include "ui/app/controls/meant_controls.h"
#include "ui/app/controls/restriction.h"
#include "ui/app/owners.h"

namespace penpose::app {
namespace {

template <FacePart part>
void only_part(EditingSession& editing, PanelState& panels, Restriction& restriction) {
  const MeantControls meant = controls_of_part(editing, panels.own.of<ControlParts>(), part);
  restriction.only(meant.names, meant.words);
}

void only_these(EditingSession& editing, Keys& keys, Controls& controls, Restriction& restriction) {
  const MeantControls meant = meant_controls(editing, keys, controls);
  restriction.only(meant.names, meant.words);
}

void not_these(EditingSession& editing, Keys& keys, Controls& controls, Restriction& restriction) {
  const MeantControls meant = meant_controls(editing, keys, controls);
  restriction.without(meant.names, meant.words);
}

constexpr std::string_view k_only_icon = "M4 5L20 5L14 12L14 19L10 17L10 12Z";

// clang-format off
constinit const std::array k_control_actions{
    ActionInfo{{"only_these"}, "Only these controls", {}, {},
     "Lines and pulls move only the selected controls, else those that the last line moved",
     k_only_icon, does<only_these>},
    ActionInfo{{"not_these"}, "Not these controls", {}, {},
     "Lines and pulls leave the selected controls alone, else those that the last line moved",
     "M4 5L20 5L14 12L14 19L10 17L10 12Z M4 20L20 4", does<not_these>},
    ActionInfo{{"only_brows"}, "Only the brows", {}, {}, "Lines and pulls move the brows alone", k_only_icon,
     does<only_part<FacePart::brows>>},
    ActionInfo{{"only_eyes"}, "Only the eyes", {}, {}, "Lines and pulls move the eyes alone", k_only_icon,
     does<only_part<FacePart::eyes>>},
    ActionInfo{{"only_mouth"}, "Only the mouth", {}, {}, "Lines and pulls move the mouth alone", k_only_icon,
     does<only_part<FacePart::mouth>>},
    ActionInfo{{"all_controls"}, "All controls", {}, {},
     "Lines and pulls may move everything again but what is locked by hand",
     "M4 5L20 5L14 12L14 19L10 17L10 12Z M16 16L21 21M21 16L16 21",
     does([](Restriction& restriction) { restriction.lift(); }),
     does([](const Restriction& restriction) { return !restriction.words().empty(); })},
    ActionInfo{{"new_to_rest"}, "Back to rest", {}, {}, "The control that was just made goes back to rest",
     "A12 13 7 -60 200M18 3L18 8L13 8",
     does([](Controls& controls) { controls.end_trial(); }),
     does([](const Controls& controls) { return controls.trial() != nullptr; })},
    ActionInfo{{"new_stays"}, "Stay there", {}, {}, "The control that was just made stays at its target",
     "M4 13L9 18L20 6",
     does([](Controls& controls) { controls.take_trial(); }),
     does([](const Controls& controls) { return controls.trial() != nullptr; })},
};
// clang-format on

}  // namespace

std::span<const ActionInfo> control_actions() { return k_control_actions; }

}  // namespace penpose::app
