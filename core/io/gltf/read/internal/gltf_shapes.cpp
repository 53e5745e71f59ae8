#include "core/io/gltf/read/internal/gltf_shapes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "core/io/gltf/read/internal/gltf_accessor.h"
#include "core/io/text/names.h"

namespace penpose::io {
namespace {

/// Takes the names that the extras of a mesh or primitive list; those that are none stay as they are.
void take_names(const json::Json& owner, std::vector<std::string>& names) {
  const json::Json* extras = json::find(owner, "extras");
  const json::Json* given = extras == nullptr ? nullptr : json::find(*extras, "targetNames");
  if (given == nullptr || !given->is_array()) return;
  for (std::size_t k = 0; k < std::min(names.size(), given->size()); ++k) {
    if (!(*given)[k].is_string()) continue;
    const auto& name = (*given)[k].get_ref<const std::string&>();
    if (!name.empty()) names[k] = name;
  }
}

/// Names of the targets of a part: those of its mesh, which most programs write, count before those of its primitive,
/// where VRM 0.x keeps them; some files name them in the first primitive of the mesh alone.
std::vector<std::string> target_names(const GltfDocument& document, const PartOrigin& origin, std::size_t count,
                                      const std::string& part_name) {
  std::vector<std::string> names;
  const std::string prefix = part_name.empty() ? "" : part_name + ".";
  for (std::size_t k = 0; k < count; ++k) names.push_back(prefix + "target" + std::to_string(k));
  const json::Json& mesh = document.json["meshes"][origin.mesh];
  take_names(mesh["primitives"][0], names);
  take_names(mesh["primitives"][origin.primitives.front()], names);
  take_names(mesh, names);
  make_unique(names);
  return names;
}

glm::vec3 vector_at(const std::vector<float>& numbers, std::size_t i) {
  return {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
}

/// Adds what one target of one part moves to its shape.
class Appender {
 public:
  Appender(rig::BlendShape& shape, std::uint32_t first_vertex) : shape_(shape), first_vertex_(first_vertex) {}

  void add(const std::optional<Elements>& deltas, const std::optional<Elements>& normals) {
    if ((deltas && deltas->has_base) || (normals && normals->has_base)) {
      add_dense(deltas, normals);
    } else {
      add_sparse(deltas, normals);
    }
  }

 private:
  void add_dense(const std::optional<Elements>& deltas, const std::optional<Elements>& normals) {
    const auto d = deltas ? deltas->dense() : std::vector<float>(normals->count * 3, 0.0F);
    const auto n = normals ? normals->dense() : std::vector<float>();
    for (std::size_t v = 0; v < d.size() / 3; ++v) {
      const glm::vec3 delta = vector_at(d, v);
      const glm::vec3 normal = normals ? vector_at(n, v) : glm::vec3(0);
      if (delta == glm::vec3(0) && normal == glm::vec3(0)) continue;
      push(v, delta, normal);
    }
  }
  void add_sparse(const std::optional<Elements>& deltas, const std::optional<Elements>& normals) {
    static const Elements k_none;
    const Elements& d = deltas ? *deltas : k_none;
    const Elements& n = normals ? *normals : k_none;
    std::size_t i = 0;
    std::size_t k = 0;
    while (i < d.sparse.size() || k < n.sparse.size()) {
      const bool from_d = i < d.sparse.size() && (k == n.sparse.size() || d.sparse[i] <= n.sparse[k]);
      const bool from_n = k < n.sparse.size() && (i == d.sparse.size() || n.sparse[k] <= d.sparse[i]);
      const std::uint32_t v = from_d ? d.sparse[i] : n.sparse[k];
      push(v, from_d ? vector_at(d.sparse_values, i) : glm::vec3(0),
           from_n ? vector_at(n.sparse_values, k) : glm::vec3(0));
      i += from_d ? 1 : 0;
      k += from_n ? 1 : 0;
    }
  }
  void push(std::size_t vertex, const glm::vec3& delta, const glm::vec3& normal) {
    const bool finite = std::isfinite(normal.x) && std::isfinite(normal.y) && std::isfinite(normal.z);
    const glm::vec3 safe_normal = finite ? normal : glm::vec3(0);
    if (safe_normal != glm::vec3(0) || !shape_.normal_deltas.empty()) {
      shape_.normal_deltas.resize(shape_.vertices.size(), glm::vec3(0));
      shape_.normal_deltas.push_back(safe_normal);
    }
    shape_.vertices.push_back(first_vertex_ + static_cast<std::uint32_t>(vertex));
    shape_.deltas.push_back(delta);
  }

  rig::BlendShape& shape_;
  std::uint32_t first_vertex_;
};

base::Result<std::optional<Elements>> read_deltas(GltfDocument& document, const std::map<std::string, int>& target,
                                                  const char* attribute, std::size_t vertex_count) {
  const auto found = target.find(attribute);
  if (found == target.end()) return std::optional<Elements>();
  auto elements = read_elements(document, found->second, {.count = vertex_count, .stays_sparse = true});
  if (!elements) return elements.error();
  return std::optional<Elements>(std::move(elements).value());
}

class ShapeCollector {
 public:
  ShapeCollector(GltfDocument& document, const RootExtras& extras) : document_(document) {
    for (const rig::Parameter& parameter : extras.shapes) known_.emplace(parameter.name, parameter);
    for (const articulation::Sketch& sketch : extras.deformers) {
      known_.emplace(sketch.name, rig::Parameter{sketch.name, 0.0, sketch.minimum, sketch.maximum});
    }
  }

  /// The number of the shape of that name, made when it is new.
  std::size_t shape(const std::string& name, double value) {
    const auto [at, is_new] = index_.try_emplace(name, result.shapes.size());
    if (!is_new) {
      differs_ = differs_ || result.values[at->second] != value;
      return at->second;
    }
    rig::BlendShape& made = result.shapes.emplace_back();
    const auto known = known_.find(name);
    if (known != known_.end()) made.parameter = known->second;
    made.parameter.name = name;
    made.parameter.minimum = std::min(made.parameter.minimum, value);
    made.parameter.maximum = std::max(made.parameter.maximum, value);
    result.values.push_back(value);
    return at->second;
  }
  void note() const {
    if (differs_) document_.notes.emplace_back("meshes give different weights to a target; the first one is used");
  }

  GltfShapes result;

 private:
  GltfDocument& document_;
  std::map<std::string, rig::Parameter> known_;
  std::map<std::string, std::size_t> index_;
  bool differs_ = false;
};

}  // namespace

base::Result<GltfShapes> read_shapes(GltfDocument& document, const GltfMeshes& meshes, const RootExtras& extras) {
  ShapeCollector collector(document, extras);
  std::size_t name_part = 0;
  for (std::size_t i = 0; i < meshes.origins.size(); ++i) {
    const PartOrigin& origin = meshes.origins[i];
    const mesh::Part& part = meshes.source.parts[i];
    const PartOrigin& named = meshes.origins[name_part];
    if (named.mesh != origin.mesh || named.node != origin.node) name_part = i;
    const auto& targets = origin.primitive(document).targets;
    const auto names = target_names(document, origin, targets.size(), meshes.source.parts[name_part].name);
    const auto& node_weights = document.model.nodes[origin.node].weights;
    const auto& weights = node_weights.empty() ? document.model.meshes[origin.mesh].weights : node_weights;
    std::vector<std::size_t> of_target;
    for (std::size_t k = 0; k < targets.size(); ++k) {
      const double value = k < weights.size() ? weights[k] : 0.0;
      if (!(std::abs(value) <= 1e9)) {
        return base::Error{"the weight of target " + std::to_string(k) + " is too large",
                           "/meshes/" + std::to_string(origin.mesh) + "/weights", "give weights of about 0 to 1"};
      }
      const std::size_t shape = collector.shape(names[k], value);
      of_target.push_back(shape);
      const auto deltas = read_deltas(document, targets[k], "POSITION", part.vertex_count);
      if (!deltas) return deltas.error();
      const auto normals = read_deltas(document, targets[k], "NORMAL", part.vertex_count);
      if (!normals) return normals.error();
      Appender(collector.result.shapes[shape], part.first_vertex).add(*deltas, *normals);
    }
    collector.result.of_target.push_back(std::move(of_target));
  }
  collector.note();
  for (rig::BlendShape& shape : collector.result.shapes) {
    if (!shape.normal_deltas.empty()) shape.normal_deltas.resize(shape.vertices.size(), glm::vec3(0));
    shape.vertices.shrink_to_fit();
    shape.deltas.shrink_to_fit();
    shape.normal_deltas.shrink_to_fit();
  }
  return std::move(collector.result);
}

std::size_t order_shapes(GltfShapes& shapes, const RootExtras& extras, const std::vector<std::string>& deformers) {
  for (const std::string& name : deformers) {
    const bool there = std::any_of(shapes.shapes.begin(), shapes.shapes.end(),
                                   [&](const rig::BlendShape& shape) { return shape.parameter.name == name; });
    if (there) continue;
    shapes.shapes.emplace_back().parameter.name = name;
    shapes.values.push_back(0.0);
  }
  std::map<std::string_view, std::size_t> rank;
  for (std::size_t i = 0; i < deformers.size(); ++i) rank.emplace(deformers[i], extras.shapes.size() + 1 + i);
  for (std::size_t i = 0; i < extras.shapes.size(); ++i) rank.emplace(extras.shapes[i].name, i);
  const auto rank_of = [&](std::size_t shape) {
    const auto found = rank.find(shapes.shapes[shape].parameter.name);
    return found == rank.end() ? extras.shapes.size() : found->second;
  };
  std::vector<std::size_t> order(shapes.shapes.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return rank_of(a) < rank_of(b); });
  GltfShapes sorted;
  std::vector<std::size_t> place(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    place[order[i]] = i;
    sorted.values.push_back(shapes.values[order[i]]);
  }
  for (const std::size_t i : order) sorted.shapes.push_back(std::move(shapes.shapes[i]));
  sorted.of_target = std::move(shapes.of_target);
  for (auto& targets : sorted.of_target) {
    for (std::size_t& shape : targets) shape = place[shape];
  }
  shapes = std::move(sorted);
  return shapes.shapes.size() - deformers.size();
}

}  // namespace penpose::io
