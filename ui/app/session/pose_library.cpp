#include "ui/app/session/pose_library.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/text/letters.h"
#include "core/document/expressions.h"
#include "ui/app/input/side_pairs.h"

namespace penpose::app {
namespace {

constexpr double k_same_moment_s = 1e-6;
/// Nobody keys poses one by one so close together, s: eight frames of 24.

}  // namespace

FacePart part_of(std::string_view control) {
  // A brow may be named beside an eye ("eyebrow"), so brows come first.
  constexpr std::array<std::pair<std::string_view, FacePart>, 14> k_words{{
      {"brow", FacePart::brows},
      {"forehead", FacePart::brows},
      {"eye", FacePart::eyes},
      {"lid", FacePart::eyes},
      {"blink", FacePart::eyes},
      {"squint", FacePart::eyes},
      {"gaze", FacePart::eyes},
      {"mouth", FacePart::mouth},
      {"lip", FacePart::mouth},
      {"jaw", FacePart::mouth},
      {"chin", FacePart::mouth},
      {"tongue", FacePart::mouth},
      {"smile", FacePart::mouth},
      {"cheek", FacePart::mouth},
  }};
  const std::string name = base::lower_case(control);
  for (const auto& [word, part] : k_words) {
    if (name.find(word) != std::string::npos) return part;
  }
  return FacePart::all;
}

std::vector<std::size_t> keys_shown(const document::Timeline& timeline) {
  const auto& keys = timeline.keys;
  // A take keys what it moves alone.
  const auto of_take = [&](std::size_t k) {
    return k < keys.size() && keys[k].name.empty() && !keys[k].controls.whole();
  };
  std::vector<std::size_t> shown;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const bool inside = k > 0 && of_take(k - 1) && of_take(k) && of_take(k + 1);
    if (!inside) shown.push_back(k);
  }
  return shown;
}

document::SetParameters values_of_choice(const document::Document& document, const PoseChoice& choice,
                                         const std::vector<std::size_t>& pairs) {
  rig::Pose to = document.pose;
  if (choice.expression) {
    const auto& expressions = document.model->expressions;
    if (*choice.expression >= expressions.size()) return {};
    document::set_expression(*document.model, expressions[*choice.expression], 1, to);
  } else {
    const auto& keys = document.timeline->keys;
    const auto key = std::find_if(keys.begin(), keys.end(), [&](const auto& one) {
      return std::abs(one.time_s - choice.time_s) < k_same_moment_s;
    });
    if (key == keys.end()) return {};
    to = key->pose;
  }
  const auto parameters = document.model->rig->parameters();
  if (choice.mirrored) to = flipped(parameters, pairs, to, document::weight_count(*document.model));
  rig::Pose pose = document.pose;
  for (std::size_t i = 0; i < pose.size(); ++i) {
    if (choice.part != FacePart::all && part_of(parameters[i].name) != choice.part) continue;
    const double value = pose[i] + choice.amount * (to[i] - pose[i]);
    pose[i] = std::clamp(value, parameters[i].minimum, parameters[i].maximum);
  }
  return values_between(parameters, document.pose, pose);
}

}  // namespace penpose::app
