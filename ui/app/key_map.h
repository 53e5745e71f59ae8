#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "ui/app/action.h"

namespace penpose::app {

/// The keys of an action: the first is the one that is shown, the second does the same.
using ActionKeys = std::array<KeyStroke, 2>;

/// Which keys actions have: the list's own, or others that were chosen. No two actions have one key.
class KeyMap {
 public:
  [[nodiscard]] ActionKeys keys_of(Action action) const;
  /// The action of a key; null when it has none.
  [[nodiscard]] const ActionInfo* action_of(const KeyStroke& pressed) const;
  /// "Ctrl+Shift+Z", the first key; empty where there is none.
  [[nodiscard]] std::string shortcut_of(Action action) const;
  /// The action's tip with the key, for a tooltip.
  [[nodiscard]] std::string tooltip_of(Action action) const;

  /// Whether its keys stay what they are: dialogs need them.
  [[nodiscard]] static bool fixed(Action action);
  /// Gives an action a key in place of its first or second one, and takes it away from whatever had it. A key of 0:
  /// it has none there.
  void set(Action action, std::size_t place, const KeyStroke& key);
  /// Its own keys again, which are taken away from whatever has them.
  void reset(Action action);
  void reset_all() { chosen_.clear(); }
  /// Whether it has other keys than its own.
  [[nodiscard]] bool changed(Action action) const { return chosen_.contains(action.name); }
  [[nodiscard]] bool any_changed() const { return !chosen_.empty(); }

  /// "ACTION|KEY|KEY" for each that has others than its own; no key, no bar.
  [[nodiscard]] std::vector<std::string> lines() const;
  /// Reads such a line. Errors (what alone): no such action, no key, a key that is reserved or another line's.
  base::Status take(std::string_view line);
  /// Behind the last line: what others have been given is nobody's own any more.
  void settle();

  friend bool operator==(const KeyMap&, const KeyMap&) = default;

 private:
  void keep(Action action, ActionKeys keys);
  void take_away(const KeyStroke& key, Action except);

  std::map<std::string, ActionKeys, std::less<>> chosen_;  ///< by the action's name
};

}  // namespace penpose::app
