#include "core/document/expressions.h"

#include <algorithm>
#include <array>
#include <map>

#include "core/rig/control_names.h"
#include "core/rig/names/face_names.h"

namespace penpose::document {
namespace {

/// What both versions call the same (VRM 0.x, blendShapeMaster, presetName; VRMC_vrm 1.0, expressions.preset), folded,
/// and the name of 1.0.
struct VrmPreset {
  std::string_view old_name, new_folded, name;
};
constexpr std::array<VrmPreset, 18> k_vrm_presets{{{"joy", "happy", "happy"},
                                                   {"angry", "angry", "angry"},
                                                   {"sorrow", "sad", "sad"},
                                                   {"fun", "relaxed", "relaxed"},
                                                   {"surprised", "surprised", "surprised"},
                                                   {"a", "aa", "aa"},
                                                   {"i", "ih", "ih"},
                                                   {"u", "ou", "ou"},
                                                   {"e", "ee", "ee"},
                                                   {"o", "oh", "oh"},
                                                   {"blink", "blink", "blink"},
                                                   {"blinkl", "blinkl", "blinkLeft"},
                                                   {"blinkr", "blinkr", "blinkRight"},
                                                   {"lookup", "lookup", "lookUp"},
                                                   {"lookdown", "lookdown", "lookDown"},
                                                   {"lookl", "lookl", "lookLeft"},
                                                   {"lookr", "lookr", "lookRight"},
                                                   {"neutral", "neutral", "neutral"}}};

const VrmPreset* preset_named(std::string_view folded) {
  for (const VrmPreset& preset : k_vrm_presets) {
    if (folded == preset.old_name || folded == preset.new_folded) return &preset;
  }
  return nullptr;
}

}  // namespace

std::optional<std::size_t> expression_named(const Model& model, std::string_view name) {
  for (std::size_t i = 0; i < model.expressions.size(); ++i) {
    if (model.expressions[i].name == name) return i;
  }
  const std::string wanted = rig::folded_name(name);
  if (wanted.empty()) return std::nullopt;
  const VrmPreset* preset = preset_named(wanted);
  std::optional<std::size_t> other;
  for (std::size_t i = 0; i < model.expressions.size(); ++i) {
    const std::string own = rig::folded_name(model.expressions[i].name);
    if (own == wanted) return i;
    if (!other && preset != nullptr && preset_named(own) == preset) other = i;
  }
  return other;
}

std::vector<std::size_t> expressions_named(const Model& model, std::string_view name) {
  if (const auto own = expression_named(model, name)) return {*own};
  const auto wanted = rig::face_name(name);
  std::vector<std::size_t> alike;
  std::vector<std::size_t> others;
  if (!wanted) return alike;
  for (std::size_t i = 0; i < model.expressions.size(); ++i) {
    const auto one = rig::face_name(model.expressions[i].name);
    if (!one || one->meaning != wanted->meaning) continue;
    if (one->side == wanted->side)
      alike.push_back(i);
    else if (one->side == rig::Side::none || wanted->side == rig::Side::none)
      others.push_back(i);
  }
  return alike.empty() ? others : alike;
}

std::string_view preset_of(std::string_view expression_name) {
  const VrmPreset* preset = preset_named(rig::folded_name(expression_name));
  return preset == nullptr ? std::string_view() : preset->name;
}

namespace {

constexpr double k_binary_from = 0.5;

double shown_alone(const Expression& expression, double weight) {
  return expression.is_binary ? (weight > k_binary_from ? 1.0 : 0.0) : weight;
}

/// Returns how an expression overrides the expressions of a preset name.
ExpressionOverride override_of(const Expression& expression, std::string_view preset) {
  constexpr std::array<std::string_view, 5> k_mouths{"aa", "ih", "ou", "ee", "oh"};
  if (preset.starts_with("blink")) return expression.blink;
  if (preset.starts_with("look")) return expression.look;
  return std::find(k_mouths.begin(), k_mouths.end(), preset) != k_mouths.end() ? expression.mouth
                                                                               : ExpressionOverride::none;
}

double left_by(ExpressionOverride does, double weight) {
  if (does == ExpressionOverride::block) return weight > 0 ? 0.0 : 1.0;
  return does == ExpressionOverride::blend ? std::clamp(1.0 - weight, 0.0, 1.0) : 1.0;
}

}  // namespace

std::vector<double> shown_weights(const Model& model, std::span<const double> weights) {
  std::vector<double> shown;
  for (std::size_t i = 0; i < model.expressions.size(); ++i)
    shown.push_back(shown_alone(model.expressions[i], weights[i]));
  const std::vector<double> alone = shown;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const std::string_view preset = preset_of(model.expressions[i].name);
    for (std::size_t k = 0; !preset.empty() && k < shown.size(); ++k) {
      if (k != i) shown[i] *= left_by(override_of(model.expressions[k], preset), alone[k]);
    }
  }
  return shown;
}

void set_expression(const Model& model, const Expression& expression, double weight, rig::Pose& pose) {
  weight = shown_alone(expression, weight);
  for (const Expression& other : model.expressions) {
    const std::string_view preset = preset_of(other.name);
    const double left = other.name == expression.name ? 1.0 : left_by(override_of(expression, preset), weight);
    if (left == 1.0) continue;
    for (const auto& [parameter, value] : other.values) {
      const double rest = model.rig->parameters()[parameter].rest;
      pose[parameter] = rest + left * (pose[parameter] - rest);
    }
  }
  for (const auto& [parameter, value] : expression.values) {
    const rig::Parameter& range = model.rig->parameters()[parameter];
    pose[parameter] = std::clamp(weight * value, range.minimum, range.maximum);
  }
}

std::vector<Expression> expressions_for(std::vector<Expression> expressions, std::span<const rig::Parameter> before,
                                        std::span<const rig::Parameter> now) {
  if (expressions.empty()) return expressions;
  std::map<std::string_view, std::size_t> place;
  for (std::size_t i = 0; i < now.size(); ++i) place.emplace(now[i].name, i);
  for (Expression& expression : expressions) {
    std::vector<std::pair<std::size_t, double>> kept;
    for (const auto& [parameter, value] : expression.values) {
      const auto found = parameter < before.size() ? place.find(before[parameter].name) : place.end();
      if (found != place.end()) kept.emplace_back(found->second, value);
    }
    std::stable_sort(kept.begin(), kept.end());
    expression.values = std::move(kept);
  }
  std::erase_if(expressions, [](const Expression& one) { return one.values.empty(); });
  return expressions;
}

}  // namespace penpose::document
