#include "core/io/fbx/motion/fbx_take.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "core/base/math.h"

namespace penpose::io {
namespace {

constexpr std::array<std::array<const char*, 3>, 3> k_curves{
    {{"d|X", "d|Y", "d|Z"}, {"d|DeformPercent", nullptr, nullptr}, {"d|Weight", nullptr, nullptr}}};

double raised(double value, double exponent) {
  if (value == 0.0) return exponent == 0.0 ? 1.0 : 0.0;
  return (value < 0.0 ? -1.0 : 1.0) * base::pow(std::abs(value), exponent);
}

/// Along the shorter way from one rotation to another.
glm::dquat part_of_way(const glm::dquat& from, glm::dquat to, double share) {
  double along = glm::dot(from, to);
  if (along < 0.0) {
    to = -to;
    along = -along;
  }
  const double angle = base::acos(std::min(along, 1.0));
  if (share == 1.0 || angle < 1e-6) return share == 1.0 ? to : from * (1.0 - share) + to * share;
  const double whole = base::sin(angle);
  return from * (base::sin((1.0 - share) * angle) / whole) + to * (base::sin(share * angle) / whole);
}

}  // namespace

FbxTake::FbxTake(const FbxScene& scene, const FbxObject& stack, FbxCurves& curves) {
  const auto moment = [&](const char* local, const char* reference) {
    return FbxScene::property(stack, local, FbxScene::property(stack, reference, 0)) / k_fbx_ticks;
  };
  start_s_ = moment("LocalStart", "ReferenceStart");
  stop_s_ = moment("LocalStop", "ReferenceStop");
  for (const FbxObject* object : scene.parts_of(stack.id, "AnimationLayer")) {
    Layer kind;
    kind.first = layers_++ == 0;
    kind.id = object->id;
    const double mode = FbxScene::property(*object, "BlendMode", 0);
    kind.adds = mode == 0.0;
    kind.replaces = mode != 0.0 && mode != 2.0;
    kind.turns_apart = FbxScene::property(*object, "RotationAccumulationMode", 0) != 0.0;
    kind.multiplies = FbxScene::property(*object, "ScaleAccumulationMode", 0) == 0.0;
    kind.weight = std::clamp(FbxScene::property(*object, "Weight", 100) / 100.0, 0.0, 1.0);
    if (FbxScene::property(*object, "Mute", 0) != 0.0 && !kind.first) continue;
    for (const FbxObject* node : scene.parts_of(object->id, "AnimationCurveNode")) add(scene, *node, kind, curves);
  }
}

void FbxTake::add(const FbxScene& scene, const FbxObject& node, const Layer& kind, FbxCurves& curves) {
  Layer layer = kind;
  bool says = false;
  for (const auto& names : k_curves) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (names[axis] == nullptr) continue;
      const int place = static_cast<int>(axis);
      const double usual = FbxScene::property(node, names[axis], std::nan(""));
      if (std::isfinite(usual)) {
        layer.otherwise[place] = usual;
        says = true;
      }
      const FbxObject* curve = scene.part_at(node.id, names[axis]);
      if (curve == nullptr || curve->kind != "AnimationCurve") continue;
      auto& read = curves[curve->id];
      if (!read) read = std::make_shared<const FbxCurve>(*curve);
      if (!read->usable()) continue;
      says = true;
      layer.axes[axis] = read;
    }
  }
  if (!says) return;
  for (const FbxConnection& to : scene.wholes_of(node.id)) {
    const FbxObject* whole = scene.object(to.object);
    if (to.property.empty() || whole == nullptr) continue;
    layer.order = fbx_rotation_order(*whole);
    all_[{to.object, to.property}].push_back(layer);
  }
}

const std::vector<FbxTake::Layer>* FbxTake::layers_of(std::int64_t object, std::string_view property) const {
  const auto at = all_.find({object, std::string(property)});
  return at == all_.end() ? nullptr : &at->second;
}

bool FbxTake::drives(std::int64_t object, std::string_view property) const {
  return layers_of(object, property) != nullptr;
}

bool FbxTake::moves(std::int64_t object, std::string_view property, const glm::dvec3& still) const {
  const auto* layers = layers_of(object, property);
  if (layers == nullptr) return false;
  for (const Layer& layer : *layers) {
    if (!layer.first) return true;
    for (int axis = 0; axis < 3; ++axis) {
      const auto& curve = layer.axes[static_cast<std::size_t>(axis)];
      if (curve ? curve->leaves(still[axis]) : std::abs(layer.otherwise[axis] - still[axis]) > 1e-9) return true;
    }
  }
  return false;
}

void FbxTake::add_curves(std::int64_t object, std::string_view property, std::vector<const FbxCurve*>& curves) const {
  const auto* layers = layers_of(object, property);
  if (layers == nullptr) return;
  for (const Layer& layer : *layers) {
    if (!layer.first && property != "Weight") add_curves(layer.id, "Weight", curves);
    for (const auto& curve : layer.axes) {
      if (curve) curves.push_back(curve.get());
    }
  }
}

glm::dvec3 FbxTake::joined(const Layer& layer, std::string_view property, const glm::dvec3& below,
                           const glm::dvec3& value, double weight) {
  if (layer.first || layer.replaces) return value;
  if (!layer.turns_apart && property == "Lcl Rotation") {
    const glm::dquat own = fbx_turn(fbx_rotation(value, layer.order));
    const glm::dquat other = fbx_turn(fbx_rotation(below, layer.order));
    const glm::dquat joined =
        layer.adds ? other * part_of_way(glm::dquat(1, 0, 0, 0), own, weight) : part_of_way(other, own, weight);
    return fbx_angles(glm::mat3_cast(joined), layer.order);
  }
  glm::dvec3 out = below;
  for (int axis = 0; axis < 3; ++axis) {
    double& one = out[axis];
    if (layer.multiplies && property == "Lcl Scaling") {
      one = (layer.adds ? one : raised(one, 1.0 - weight)) * raised(value[axis], weight);
    } else {
      one = (layer.adds ? one : one * (1.0 - weight)) + value[axis] * weight;
    }
  }
  return out;
}

double FbxTake::weight_of(const Layer& layer, double time_s) const {
  const auto* layers = layers_of(layer.id, "Weight");
  const auto* curve = layers == nullptr ? nullptr : layers->front().axes[0].get();
  return curve == nullptr ? layer.weight : std::clamp(curve->at(time_s) / 100.0, 0.0, 1.0);
}

glm::dvec3 FbxTake::value(std::int64_t object, std::string_view property, const glm::dvec3& still,
                          double time_s) const {
  glm::dvec3 now = still;
  const auto* layers = layers_of(object, property);
  if (layers == nullptr) return now;
  for (const Layer& layer : *layers) {
    glm::dvec3 value = layer.otherwise;
    for (int axis = 0; axis < 3; ++axis) {
      if (std::isnan(value[axis]))
        value[axis] = layer.first || !layer.adds                      ? now[axis]
                      : property == "Lcl Scaling" && layer.multiplies ? 1.0
                                                                      : 0.0;
      if (const auto& curve = layer.axes[static_cast<std::size_t>(axis)]) value[axis] = curve->at(time_s);
    }
    now = joined(layer, property, now, value, weight_of(layer, time_s));
  }
  return now;
}

std::vector<std::int64_t> FbxTake::objects() const {
  std::vector<std::int64_t> out;
  for (const auto& [name, layers] : all_) {
    if (out.empty() || out.back() != name.object) out.push_back(name.object);
  }
  return out;
}

std::vector<std::pair<std::string, FbxTake>> fbx_takes(const FbxScene& scene) {
  std::vector<std::pair<std::string, FbxTake>> out;
  FbxCurves curves;
  for (const FbxObject& stack : scene.objects()) {
    if (stack.kind == "AnimationStack") out.emplace_back(stack.name, FbxTake(scene, stack, curves));
  }
  return out;
}

}  // namespace penpose::io
