#include "core/tracking/driven_controls.h"

#include <algorithm>

#include "core/document/expressions.h"
#include "core/rig/control_names.h"
#include "core/rig/names/face_names.h"

namespace penpose::tracking {
namespace {

std::vector<std::string_view> split(std::string_view text, char at) {
  std::vector<std::string_view> pieces;
  while (true) {
    const std::size_t end = std::min(text.find(at), text.size());
    if (end > 0) pieces.push_back(text.substr(0, end));
    if (end == text.size()) return pieces;
    text.remove_prefix(end + 1);
  }
}

/// "0.25" as a number; these tables have no other form.
double gain_of(std::string_view text) {
  double value = 0;
  double unit = 1;
  bool after = false;
  for (const char c : text) {
    if (c == '.') {
      after = true;
      continue;
    }
    if (after) unit /= 10;
    value = after ? value + unit * (c - '0') : value * 10 + (c - '0');
  }
  return value;
}

class Finder {
 public:
  explicit Finder(const document::Model& model) : model_(model) {}

  void add(const DrivenControl& control) {
    const auto same = [&](const DrivenControl& one) { return one.parameter == control.parameter; };
    if (std::none_of(found_.begin(), found_.end(), same)) found_.push_back(control);
  }

  /// By its own name: a control's, or an expression's; on the side that is asked for, or on none.
  bool add_named(std::string_view name, double gain, rig::Side side = rig::Side::none) {
    if (side != rig::Side::none) {
      const std::string sided = std::string(name) + (side == rig::Side::left ? "_L" : "_R");
      if (add_named(sided, gain)) return true;
    }
    const auto own = rig::controls_named(model_.rig->parameters(), name);
    for (const std::size_t p : own) add({p, gain});
    if (!own.empty()) return true;
    const auto expressions = document::expressions_named(model_, name);
    for (const std::size_t one : expressions) {
      for (const auto& [p, value] : model_.expressions[one].values)
        add({p, gain * (value - model_.rig->parameters()[p].rest), one, gain});
    }
    return !expressions.empty();
  }

  /// Adds the sets that stand for what a name means. Returns true if one applies, even one that moves nothing.
  bool add_instead(std::string_view name, int depth) {
    const auto known = rig::face_name(name);
    if (!known || depth > 2) return false;
    for (std::string_view set : split(rig::face_meanings()[known->meaning].instead, '|')) {
      if (set == "-") return true;
      if (set.starts_with('=')) {
        if (add_instead(set.substr(1), depth + 1)) return true;
        continue;
      }
      const bool all = set.starts_with("all:");
      if (all) set.remove_prefix(4);
      const auto names = split(set, ' ');
      if (all && !has_all(names)) continue;
      bool any = false;
      for (std::size_t i = 0; i < (all ? 1 : names.size()); ++i) {
        const auto parts = split(names[i], '*');
        any = add_named(parts[0], parts.size() > 1 ? gain_of(parts[1]) : 1.0, known->side) || any;
      }
      if (any) return true;
    }
    return false;
  }

  [[nodiscard]] std::vector<DrivenControl> take() {
    std::stable_sort(found_.begin(), found_.end(),
                     [](const DrivenControl& a, const DrivenControl& b) { return a.parameter < b.parameter; });
    return std::move(found_);
  }

 private:
  [[nodiscard]] bool has_all(const std::vector<std::string_view>& names) const {
    return std::all_of(names.begin(), names.end(), [&](std::string_view name) {
      Finder one(model_);
      return one.add_named(split(name, '*')[0], 1);
    });
  }

  const document::Model& model_;
  std::vector<DrivenControl> found_;
};

bool find(const document::Model& model, std::string_view name, std::vector<DrivenControl>& found) {
  Finder finder(model);
  const bool any = finder.add_named(name, 1) || finder.add_instead(name, 0);
  found = finder.take();
  return any;
}

}  // namespace

std::vector<DrivenControl> driven_controls(const document::Model& model, std::string_view name) {
  std::vector<DrivenControl> found;
  find(model, name, found);
  return found;
}

bool is_driven(const document::Model& model, std::string_view name) {
  std::vector<DrivenControl> found;
  return find(model, name, found);
}

}  // namespace penpose::tracking
