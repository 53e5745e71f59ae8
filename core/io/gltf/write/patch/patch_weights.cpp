#include "core/io/gltf/write/patch/patch_weights.h"

#include <algorithm>

namespace penpose::io {

void PatchWeights::write() {
  for (const MeshTargets& mesh : state_.targets.meshes()) {
    for (const TargetColumn& column : mesh.columns) {
      const auto weight = weight_to_write(column);
      if (weight) set_weight(mesh, static_cast<std::size_t>(&column - mesh.columns.data()), *weight);
    }
  }
}

/// None: it stays what it is in the file.
std::optional<double> PatchWeights::weight_to_write(const TargetColumn& column) const {
  const std::size_t target = column.target;
  const std::string helped = target >= state_.morphs.all().size() ? base_of(column.name) : std::string();
  if (target == k_no_target && helped.empty()) return std::nullopt;
  if (target < state_.width())
    return state_.posed[target] || !column.old ? std::optional(posed_weight(target)) : std::nullopt;
  if (target < state_.morphs.all().size()) return state_.weights->posed(target);
  // One that takes a part of the weight of another.
  const std::size_t base = state_.target_named(helped);
  if (base < state_.width() && !state_.posed[base]) return column.old ? std::nullopt : std::optional(0.0);
  return target == k_no_target ? 0.0 : state_.weights->posed(target);
}

/// A control that was not posed has no other targets that help it.
double PatchWeights::posed_weight(std::size_t target) const {
  return state_.posed[target] ? state_.weights->posed(target) : state_.model.pose[target];
}

std::string PatchWeights::base_of(const std::string& helper) const {
  for (const OneWayName& one : state_.targets.one_way_names(*state_.weights)) {
    if (one.target == helper) return one.name;
  }
  return {};
}

void PatchWeights::set_weight(const MeshTargets& mesh, std::size_t column, double weight) {
  json::Json& object = state_.builder.root["meshes"][mesh.written];
  json::Json& holder = state_.builder.root["nodes"][mesh.node];
  const json::Json* own = json::find(holder, "weights");
  const bool has_own = own != nullptr && !own->empty();
  const json::Json* now = has_own ? own : json::find(object, "weights");
  const double is = now != nullptr && column < now->size() ? (*now)[column].get<double>() : 0.0;
  if (is == weight) return;
  state_.changed = true;
  json::Json list = now == nullptr ? json::Json::array() : *now;
  while (list.size() < mesh.columns.size()) list.push_back(0);
  list[column] = weight;
  (has_own || state_.users_of(mesh.written) > 1 ? holder : object)["weights"] = std::move(list);
}

std::vector<WeightNode> PatchWeights::nodes() const {
  std::vector<WeightNode> nodes;
  for (const MeshTargets& mesh : state_.targets.meshes()) {
    if (mesh.columns.empty()) continue;
    WeightNode& made = nodes.emplace_back(WeightNode{mesh.node, {}});
    for (const TargetColumn& column : mesh.columns) made.targets.push_back(column.target);
  }
  return nodes;
}

}  // namespace penpose::io
