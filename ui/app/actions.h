#pragma once

#include "ui/app/action.h"

namespace penpose::app {

/// Does actions by their names. Whoever offers one needs nothing else of the app.
class Actions {
 public:
  explicit Actions(App& app) : app_(app) {}

  void run(Action action);
  /// Runs the action of a key, if it has one.
  void press(const KeyStroke& key);
  /// Whether it can be used now.
  [[nodiscard]] bool usable(Action action) const;

 private:
  App& app_;
};

}  // namespace penpose::app
