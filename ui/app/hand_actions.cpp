#include "ui/app/hand_actions.h"

#include <array>

#include "ui/app/owners.h"

namespace penpose::app {
namespace {

struct HandSteadiness {
  const char* words;
  double unsteadiness;
};
constexpr std::array k_hands{HandSteadiness{"Steady hand", 0.5}, HandSteadiness{"Usual hand", 1.0},
                             HandSteadiness{"Unsteady hand", 2.0}};

std::size_t hand_of(double unsteadiness) {
  std::size_t is = 0;
  while (is + 1 < k_hands.size() && k_hands[is].unsteadiness < unsteadiness) ++is;
  return is;
}

void next_hand(EditingSession& editing) {
  const std::size_t next = (hand_of(editing.document().hand) + 1) % k_hands.size();
  editing.perform(document::SetHand{k_hands[next].unsteadiness});
}

// clang-format off
constinit const std::array k_hand_actions{
    ActionInfo{{"pressure"}, "Pressure", {}, {}, "Press harder to pull a target harder",
     "M4 20L9 20L13 18L16 14L18 8L19 4M4 16L8 16M4 12L10 12",
     does([](EditingSession& editing) {
       editing.perform(document::SetPressureWeighting{!editing.document().pressure_weighting});
     })},
    ActionInfo{{"hand"}, "Steadiness", {}, {},
     "How steady the hand is: what a line strays by is not taken for a wish. Press for the next of three",
     "M3 9L7 6L11 9L15 6L21 9M3 16L9 16L21 16", does<next_hand>},
    ActionInfo{{"sessions"}, "Sessions", {}, {}, "Earlier sessions, to play or continue",
     "C12 12 8D12 12 3", does([](Dialogs& dialogs) { dialogs.show(Dialog::sessions); })},
    ActionInfo{{"tablet"}, "Tablet", {}, {}, "Tablet area and pressure", "M3 6L21 6L21 18L3 18Z M8 14L16 9",
     does([](Dialogs& dialogs) { dialogs.show(Dialog::tablet); })},
    ActionInfo{{"tablet_keys"}, "Tablet keys", {}, {}, "What tablet keys, rings and pen buttons do",
     "M4 5L20 5L20 19L4 19Z M8 9L8 11M12 9L12 11M16 9L16 11M8 15L16 15",
     does([](Dialogs& dialogs) { dialogs.show(Dialog::pad); })},
    ActionInfo{{"pen_menu"}, "Pen menu", {}, {}, "Choose the entries of the pen menu", "C12 12 8C12 12 2.5",
     does([](Dialogs& dialogs) { dialogs.show(Dialog::radial); })},
    ActionInfo{{"screen_keyboard"}, "Screen keyboard", {}, {}, "Show a keyboard on screen while you type",
     "M3 8L21 8L21 20L3 20Z M7 12L7 12.5M12 12L12 12.5M17 12L17 12.5M8 16.5L16 16.5M12 2L12 5M9 4L12 2L15 4",
     does([](PanelState& panels) { panels.has_keyboard = false; }),
     does([](const PanelState& panels) { return panels.has_keyboard; })},
};
// clang-format on

}  // namespace

std::span<const ActionInfo> hand_actions() { return k_hand_actions; }

const char* steadiness_words(double unsteadiness) { return k_hands[hand_of(unsteadiness)].words; }

}  // namespace penpose::app
