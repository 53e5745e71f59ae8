#include "core/poses/take_pose.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/poses/effect_fit.h"
#include "core/poses/line_fit.h"
#include "core/tracking/driven_controls.h"

namespace penpose::poses {
namespace {

constexpr std::array<std::string_view, 3> k_ways{"names", "effects", "lines"};

/// A way that leaves more than this of what the pose asks for is no way: the next one is tried.
constexpr double k_no_way = 0.9;
/// Names that leave more than this of it may mean something else here: what controls do is tried, too.
constexpr double k_about = 0.4;
/// Moves of less than this, of the face's size and over all places, ask for nothing.
constexpr double k_nothing = 1e-3;

class Taker {
 public:
  Taker(const KeptPose& pose, const document::Model& model, const FaceMeasure* face, FacePart part)
      : pose_(pose), model_(model), rig_(*model.rig), face_(face), part_(part) {
    if (face_ != nullptr) asked_ = asked_of(*face_, pose_.moves, part_);
  }

  [[nodiscard]] bool asks() const { return face_ != nullptr && asked_.size() > k_nothing * face_->size(); }

  /// What the names give. `measured`: also of controls whose effect is measured; else of the others alone.
  TakenPose by_names(bool measured) {
    TakenPose taken;
    taken.way = Way::names;
    const auto parameters = rig_.parameters();
    std::vector<std::optional<double>> values(parameters.size());
    const bool same_rig =
        std::equal(pose_.controls.begin(), pose_.controls.end(), parameters.begin(), parameters.end(),
                   [](const std::string& name, const rig::Parameter& one) { return name == one.name; });
    // Controls that were at rest go back there, where they bear the same name.
    for (const std::string& name : pose_.controls) {
      const auto at = rig::find_parameter(parameters, name);
      if (at && measured && of_part(*at)) values[*at] = parameters[*at].rest;
    }
    for (const KeptValue& one : pose_.values) {
      if (!measured && !one.does.empty()) continue;
      if (!same_rig && !is_asked(one)) continue;
      const auto own = rig::find_parameter(parameters, one.control);
      if (own) {
        if (of_part(*own)) set(values, *own, one.value, taken);
        continue;
      }
      const auto driven = tracking::driven_controls(model_, one.control);
      if (driven.empty()) taken.missing.push_back(one.control);
      for (const auto& control : driven) {
        const double rest = parameters[control.parameter].rest;
        if (of_part(control.parameter)) set(values, control.parameter, rest + control.gain * one.value, taken);
      }
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (values[i]) taken.values.push_back({parameters[i].name, *values[i]});
    }
    return measured_of(std::move(taken));
  }

  TakenPose by_effects() { return of_pose(Way::effects, fit_effects(*face_, rig_, asked_, part_)); }

  base::Result<TakenPose> by_lines() {
    const auto pose = fit_lines(*face_, rig_, pose_.lines, part_);
    if (!pose) return pose.error();
    return of_pose(Way::lines, *pose);
  }

 private:
  /// Whether a control of the rig is of the part that is taken.
  [[nodiscard]] bool of_part(std::size_t parameter) const {
    return part_ == FacePart::all || (face_ != nullptr && face_->moves(parameter, part_));
  }
  /// Whether a control of the pose does something to the part that is taken.
  [[nodiscard]] bool is_asked(const KeptValue& one) const {
    return part_ == FacePart::all || one.does.empty() ||
           std::any_of(one.does.begin(), one.does.end(),
                       [&](const auto& deed) { return part_of_feature(deed.first) == part_; });
  }
  void set(std::vector<std::optional<double>>& values, std::size_t parameter, double value, TakenPose& taken) const {
    const rig::Parameter& one = rig_.parameters()[parameter];
    const double inside = std::clamp(value, one.minimum, one.maximum);
    if (inside != value) taken.clamped.push_back(one.name);
    values[parameter] = inside;
  }
  TakenPose measured_of(TakenPose taken) const {
    if (asks()) taken.left = left_of(*face_, asked_, with_values(rig_, rig::rest_pose(rig_), taken.values));
    return taken;
  }
  /// A solved pose: all controls that move the features, and by name those of the pose that move none.
  TakenPose of_pose(Way way, const rig::Pose& pose) {
    TakenPose taken = by_names(false);
    taken.way = way;
    const auto parameters = rig_.parameters();
    std::erase_if(taken.values, [&](const document::NamedValue& one) {
      return face_->moves(*rig::find_parameter(parameters, one.name), part_);
    });
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      if (face_->moves(i, part_)) taken.values.push_back({parameters[i].name, pose[i]});
    }
    return measured_of(std::move(taken));
  }

  const KeptPose& pose_;
  const document::Model& model_;
  const rig::Rig& rig_;
  const FaceMeasure* face_;
  FacePart part_;
  AskedMoves asked_;
};

bool fits(const TakenPose& taken) { return !taken.left || *taken.left < k_no_way; }

base::Error nothing_for(const KeptPose& pose, const std::string& why) {
  return {"nothing of the pose \"" + pose.name + "\" can be taken: " + why, "",
          "take it to a rig with controls of its names, or with a face whose features are found"};
}

std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t k_said = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), k_said); ++i) text += (i > 0 ? ", " : "") + names[i];
  if (names.size() > k_said) text += " and " + std::to_string(names.size() - k_said) + " more";
  return text;
}

}  // namespace

std::string_view name_of(Way way) { return k_ways[static_cast<std::size_t>(way)]; }

std::optional<Way> way_named(std::string_view name) {
  for (std::size_t i = 0; i < k_ways.size(); ++i) {
    if (k_ways[i] == name) return static_cast<Way>(i);
  }
  return std::nullopt;
}

base::Result<TakenPose> take_pose(const KeptPose& pose, const document::Model& model, const FaceMeasure* face,
                                  const TakeOptions& options) {
  Taker taker(pose, model, face, options.part);
  const auto may = [&](Way way) { return !options.way || *options.way == way; };
  std::optional<TakenPose> names;
  if (may(Way::names)) {
    names = taker.by_names(true);
    const bool whole = names->missing.empty() && (!names->left || *names->left < k_about);
    if (!names->values.empty() && (whole || options.way)) return *names;
  }
  // A pose at rest asks for nothing, and is taken so.
  const bool rests = pose.values.empty() && (pose.lines.empty() || !pose.moves.empty());
  if (may(Way::effects) && face != nullptr && (taker.asks() || rests)) {
    TakenPose effects = taker.by_effects();
    const bool names_are_nearer =
        names && names->missing.empty() && names->left && effects.left && *names->left <= *effects.left;
    if (names_are_nearer && fits(*names)) return *names;
    if (!effects.values.empty() && (fits(effects) || options.way)) return effects;
  }
  std::string why = "no control of it is here";
  if (may(Way::lines) && face != nullptr && !pose.lines.empty()) {
    auto lines = taker.by_lines();
    if (lines && !lines->values.empty() && (fits(*lines) || options.way)) return lines;
    if (!lines) why = lines.error().what;
  }
  const bool some = names && names->missing.size() < pose.values.size();
  if (some && !names->values.empty()) return *names;
  if (options.way == Way::effects) why = "it has no measured moves of features that this face has";
  if (options.way == Way::lines && pose.lines.empty()) why = "it was kept without lines";
  return nothing_for(pose, why);
}

rig::Pose with_values(const rig::Rig& rig, rig::Pose pose, const std::vector<document::NamedValue>& values) {
  for (const auto& [name, value] : values) {
    if (const auto at = rig::find_parameter(rig.parameters(), name)) pose[*at] = value;
  }
  return pose;
}

std::string words_of(const KeptPose& pose, const TakenPose& taken) {
  constexpr std::array<const char*, 3> k_by{" by the names of its controls", " by what controls do",
                                            " by the lines that it was drawn with"};
  std::string text = "\"" + pose.name + "\" is taken" + k_by[static_cast<std::size_t>(taken.way)];
  if (taken.left && *taken.left >= 0.05)
    text += "; " + std::to_string(static_cast<int>(std::round(100 * std::max(0.0, 1 - *taken.left)))) +
            " % of it is reached";
  if (!taken.missing.empty()) text += "; nothing here stands for " + listed(taken.missing);
  if (!taken.clamped.empty()) text += "; at the end of its range: " + listed(taken.clamped);
  return text;
}

}  // namespace penpose::poses
