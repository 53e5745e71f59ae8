#pragma once

#include <any>
#include <map>
#include <typeindex>

namespace penpose::app {

/// The states of panels and dialogs, by their types: each keeps its own, and nobody else has to know of it.
class States {
 public:
  /// Made when it is first asked for.
  template <typename State>
  [[nodiscard]] State& of() {
    std::any& slot = all_[std::type_index(typeid(State))];
    if (!slot.has_value()) slot.emplace<State>();
    return *std::any_cast<State>(&slot);
  }

 private:
  std::map<std::type_index, std::any> all_;
};

}  // namespace penpose::app
