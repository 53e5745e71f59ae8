#pragma once

#include "ui/app/key_map.h"

namespace penpose::app {

/// Does actions by their names. Whoever offers one needs nothing else of the app.
class Actions {
 public:
  explicit Actions(App& app) : app_(app) {}

  void run(Action action);
  /// Runs the action of a key, if it has one.
  void press(const KeyStroke& key);
  /// Which keys they have.
  [[nodiscard]] const KeyMap& keys() const;
  /// Whether it can be used now.
  [[nodiscard]] bool usable(Action action) const;

 private:
  App& app_;
};

}  // namespace penpose::app
