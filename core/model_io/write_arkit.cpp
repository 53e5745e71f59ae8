#include "core/model_io/write_arkit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/numbers.h"
#include "core/document/animation_sampling.h"
#include "core/rig/control_names.h"

namespace penpose::model_io {
namespace {

/// The 52 blend shapes of ARKit (ARFaceAnchor.BlendShapeLocation) as Live Link Face spells them.
constexpr std::array<const char*, 52> k_names = {"EyeBlinkLeft",
                                                 "EyeLookDownLeft",
                                                 "EyeLookInLeft",
                                                 "EyeLookOutLeft",
                                                 "EyeLookUpLeft",
                                                 "EyeSquintLeft",
                                                 "EyeWideLeft",
                                                 "EyeBlinkRight",
                                                 "EyeLookDownRight",
                                                 "EyeLookInRight",
                                                 "EyeLookOutRight",
                                                 "EyeLookUpRight",
                                                 "EyeSquintRight",
                                                 "EyeWideRight",
                                                 "JawForward",
                                                 "JawRight",
                                                 "JawLeft",
                                                 "JawOpen",
                                                 "MouthClose",
                                                 "MouthFunnel",
                                                 "MouthPucker",
                                                 "MouthRight",
                                                 "MouthLeft",
                                                 "MouthSmileLeft",
                                                 "MouthSmileRight",
                                                 "MouthFrownLeft",
                                                 "MouthFrownRight",
                                                 "MouthDimpleLeft",
                                                 "MouthDimpleRight",
                                                 "MouthStretchLeft",
                                                 "MouthStretchRight",
                                                 "MouthRollLower",
                                                 "MouthRollUpper",
                                                 "MouthShrugLower",
                                                 "MouthShrugUpper",
                                                 "MouthPressLeft",
                                                 "MouthPressRight",
                                                 "MouthLowerDownLeft",
                                                 "MouthLowerDownRight",
                                                 "MouthUpperUpLeft",
                                                 "MouthUpperUpRight",
                                                 "BrowDownLeft",
                                                 "BrowDownRight",
                                                 "BrowInnerUp",
                                                 "BrowOuterUpLeft",
                                                 "BrowOuterUpRight",
                                                 "CheekPuff",
                                                 "CheekSquintLeft",
                                                 "CheekSquintRight",
                                                 "NoseSneerLeft",
                                                 "NoseSneerRight",
                                                 "TongueOut"};

std::string arkit_name(const std::string& own) {
  const std::string folded = rig::folded_name(own);
  for (const char* name : k_names) {
    if (rig::folded_name(name) == folded) return name;
  }
  // A comma or a quote in a name would end its cell.
  std::string safe = own;
  std::replace_if(
      safe.begin(), safe.end(), [](char c) { return c == ',' || c == '"' || c == '\n' || c == '\r'; }, '_');
  return safe;
}

void add_padded(std::int64_t number, std::string& out) {
  if (number < 10) out += '0';
  out += std::to_string(number);
}

std::string timecode(double time_s) {
  const auto whole = static_cast<std::int64_t>(time_s);
  std::string text;
  add_padded(whole / 3600 % 24, text);
  text += ':';
  add_padded(whole / 60 % 60, text);
  text += ':';
  add_padded(whole % 60, text);
  text += ':';
  // Rounding must not make a frame 60 of a second.
  const double frames = std::min(59.999, (time_s - static_cast<double>(whole)) * 60.0);
  if (frames < 9.9995) text += '0';
  return text + base::format_fixed(frames, 3);
}

}  // namespace

base::Result<std::string> write_arkit(const document::Model& model, double fps) {
  const std::size_t weights = document::weight_count(model);
  if (weights == 0) {
    return base::Error{"the model has no blend shape or deformer", "", "give a model with blend shapes"};
  }
  const bool moves = !model.animations.empty();
  const double last = moves ? std::round(document::duration_s(model.animations.front()) * fps) : 0;
  if (!(last < 1e6)) return base::Error{"the animation has over 1,000,000 frames", "", "choose a lower frame rate"};
  std::string text = "Timecode,BlendShapeCount";
  for (std::size_t i = 0; i < weights; ++i) {
    text += ',';
    text += arkit_name(model.rig->parameters()[i].name);
  }
  text += '\n';
  for (std::size_t f = 0; f <= static_cast<std::size_t>(last); ++f) {
    const double time = static_cast<double>(f) / fps;
    std::vector<double> values(model.pose.begin(), model.pose.begin() + static_cast<std::ptrdiff_t>(weights));
    if (moves) {
      const auto moment = document::sample(model, model.animations.front(), time);
      if (moment.weights.size() == weights) values = moment.weights;
    }
    text += timecode(time);
    text += ',';
    text += std::to_string(weights);
    for (const double value : values) {
      text += ',';
      text += base::format_double(value);
    }
    text += '\n';
  }
  return text;
}

}  // namespace penpose::model_io
