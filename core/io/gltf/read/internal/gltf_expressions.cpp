#include "core/io/gltf/read/internal/gltf_expressions.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/base/text/utf8.h"
#include "core/io/gltf/internal/gltf_extras.h"

namespace penpose::io {
namespace {

/// More than any avatar has; a hostile file must not make each byte unfold to many values.
constexpr std::size_t k_most_expressions = 1000;

class Expressions {
 public:
  Expressions(GltfDocument& document, const GltfMeshes& meshes, const GltfShapes& shapes, std::size_t count)
      : document_(document), meshes_(meshes), shapes_(shapes), count_(count) {}

  std::vector<document::Expression> read() {
    const json::Json* extensions = json::find(document_.json, "extensions");
    const json::Json* vrm1 = extensions == nullptr ? nullptr : json::find(*extensions, "VRMC_vrm");
    const json::Json* vrm0 = extensions == nullptr ? nullptr : json::find(*extensions, "VRM");
    for (std::size_t i = 0; i < meshes_.origins.size(); ++i) {
      parts_of_[vrm1 != nullptr ? meshes_.origins[i].node : meshes_.origins[i].mesh].push_back(i);
    }
    // A file of both versions is one of the newer.
    if (vrm1 != nullptr) {
      read_vrm1(*vrm1);
    } else if (vrm0 != nullptr) {
      read_vrm0(*vrm0);
    } else {
      read_own();
    }
    if (more_ > 0) document_.notes.push_back("and " + std::to_string(more_) + " binds more are left out");
    if (colours_) document_.notes.emplace_back("expressions change materials too; that is not shown");
    return std::move(result_);
  }

 private:
  /// The weight of each target: by its shape, and the node or mesh that it is of.
  using Weights = std::map<std::pair<std::size_t, std::int64_t>, double>;

  /// As penpose itself keeps them in a file that is no avatar (gltf_extras.h).
  void read_own() {
    const json::Json* extras = json::find(document_.json, "extras");
    const json::Json* own = extras == nullptr ? nullptr : json::find(*extras, k_extras_key);
    const json::Json* list = own == nullptr ? nullptr : json::find(*own, "expressions");
    if (list == nullptr || !list->is_array()) return;
    std::map<std::string_view, std::size_t> shape_of;
    for (std::size_t i = 0; i < count_; ++i) shape_of.emplace(shapes_.shapes[i].parameter.name, i);
    for (const json::Json& one : *list) {
      const json::Json* name = json::find(one, "name");
      const json::Json* values = json::find(one, "values");
      if (name == nullptr || !name->is_string() || values == nullptr || !values->is_object()) continue;
      Weights weights;
      for (const auto& [target, value] : values->items()) {
        const auto shape = shape_of.find(target);
        const double weight = json::number(value).value_or(0);
        if (shape != shape_of.end() && std::abs(weight) <= 100) weights[{shape->second, 0}] = weight;
      }
      if (add_shape(name->get<std::string>(), nullptr, weights)) read_ways(one, result_.back());
    }
  }

  void read_vrm1(const json::Json& vrm) {
    const json::Json* expressions = json::find(vrm, "expressions");
    for (const char* group : {"preset", "custom"}) {
      const json::Json* members = expressions == nullptr ? nullptr : json::find(*expressions, group);
      if (members == nullptr || !members->is_object()) continue;
      for (const auto& [name, expression] : members->items()) {
        Weights weights;
        const json::Json* binds = json::find(expression, "morphTargetBinds");
        add_binds(binds, name, "node", 1.0, weights);
        for (const char* other : {"materialColorBinds", "textureTransformBinds"}) {
          const json::Json* list = json::find(expression, other);
          colours_ = colours_ || (list != nullptr && list->is_array() && !list->empty());
        }
        if (add_shape(name, binds, weights)) read_ways(expression, result_.back());
      }
    }
  }

  /// How an expression is shown: members of VRMC_vrm 1.0, which penpose keeps by the same names.
  static void read_ways(const json::Json& from, document::Expression& to) {
    using enum document::ExpressionOverride;
    const json::Json* binary = json::find(from, "isBinary");
    to.is_binary = binary != nullptr && binary->is_boolean() && binary->get<bool>();
    for (const auto& [name, member] : {std::pair("overrideMouth", &to.mouth), std::pair("overrideBlink", &to.blink),
                                       std::pair("overrideLookAt", &to.look)}) {
      const json::Json* does = json::find(from, name);
      if (does == nullptr || !does->is_string()) continue;
      *member = *does == "block" ? block : *does == "blend" ? blend : none;
    }
  }

  void read_vrm0(const json::Json& vrm) {
    const json::Json* master = json::find(vrm, "blendShapeMaster");
    const json::Json* groups = master == nullptr ? nullptr : json::find(*master, "blendShapeGroups");
    if (groups == nullptr || !groups->is_array()) return;
    for (const json::Json& group : *groups) {
      Weights weights;
      const std::string name = name_of(group);
      const json::Json* binds = json::find(group, "binds");
      // Weights of VRM 0 are percent.
      add_binds(binds, name.empty() ? "without a name" : name, "mesh", 0.01, weights);
      const json::Json* materials = json::find(group, "materialValues");
      colours_ = colours_ || (materials != nullptr && materials->is_array() && !materials->empty());
      if (name.empty() || !add_shape(name, binds, weights)) continue;
      read_ways(group, result_.back());
    }
  }

  static std::string name_of(const json::Json& group) {
    for (const char* key : {"name", "presetName"}) {
      const json::Json* name = json::find(group, key);
      if (name != nullptr && name->is_string() && !name->get_ref<const std::string&>().empty())
        return name->get<std::string>();
    }
    return {};
  }

  /// Adds the binds' moves and notes those that name nothing: without a word a face would lack half of its smile.
  void add_binds(const json::Json* binds, const std::string& name, const char* key, double scale, Weights& weights) {
    constexpr std::size_t k_most_notes = 20;
    for (std::size_t i = 0; binds != nullptr && binds->is_array() && i < binds->size(); ++i) {
      const std::string problem = add_bind((*binds)[i], key, scale, weights);
      if (problem.empty()) continue;
      if (bad_++ < k_most_notes) {
        document_.notes.push_back("expression " + base::valid_utf8(name) + ": bind " + std::to_string(i) +
                                  " is left out: " + problem);
      } else {
        ++more_;
      }
    }
  }

  /// One morph target of all parts of a node or a mesh. Says what is wrong with it, or nothing.
  std::string add_bind(const json::Json& bind, const char* key, double scale, Weights& weights) {
    const json::Json* owner = json::find(bind, key);
    const json::Json* index = json::find(bind, "index");
    const json::Json* given = json::find(bind, "weight");
    const std::int64_t owner_number = owner == nullptr ? -1 : json::whole_number(*owner, 0, 0x7fffffff).value_or(-1);
    const std::int64_t target = index == nullptr ? -1 : json::whole_number(*index, 0, 0x7fffffff).value_or(-1);
    const double weight = given == nullptr ? 1.0 : json::number(*given).value_or(0) * scale;
    const std::string owned_by = std::string(key).append(" ").append(std::to_string(owner_number));
    if (owner_number < 0) return std::string("it names no ") + key;
    if (target < 0) return "it names no target of " + owned_by;
    if (!(std::abs(weight) <= 100)) return "its weight is no number that can be used";
    const auto parts = parts_of_.find(static_cast<std::size_t>(owner_number));
    if (parts == parts_of_.end()) return owned_by + " is not there or shows nothing";
    bool found = false;
    std::set<std::size_t> added;  // parts of a mesh have the same targets, most often of the same names
    for (const std::size_t i : parts->second) {
      const auto& targets = shapes_.of_target[i];
      if (static_cast<std::size_t>(target) >= targets.size()) continue;
      if (document_.budget == 0) return "the file unfolds to more than can be kept";
      --document_.budget;
      found = true;
      const std::size_t shape = targets[static_cast<std::size_t>(target)];
      // What only shows a sketched control to other programs is no control.
      if (shape < count_ && added.insert(shape).second) weights[{shape, owner_number}] += weight;
    }
    if (found) return {};
    return owned_by + " has no morph target " + std::to_string(target);
  }

  /// Returns whether the expression is kept, as the last one.
  bool add_shape(const std::string& name, const json::Json* binds, const Weights& weights) {
    const std::string valid = base::valid_utf8(name);
    std::map<std::size_t, double> of_shape;
    for (const auto& [target, weight] : weights) {
      double& kept = of_shape[target.first];
      if (std::abs(weight) > std::abs(kept)) kept = weight;
    }
    std::erase_if(of_shape, [](const auto& one) { return one.second == 0.0; });
    // Those without binds are common: they change colours, or nothing at all.
    if (of_shape.empty() && (binds == nullptr || !binds->is_array() || binds->empty())) return false;
    std::string problem;
    if (of_shape.empty()) problem = "it moves nothing";
    if (result_.size() == k_most_expressions) problem = "there are over 1000";
    if (problem.empty() && !names_.insert(valid).second) problem = "another has its name";
    if (!problem.empty()) {
      if (++unused_ <= 20) document_.notes.push_back("expression " + valid + " is left out: " + problem);
      return false;
    }
    document::Expression& kept = result_.emplace_back();
    kept.name = valid;
    kept.values.assign(of_shape.begin(), of_shape.end());
    return true;
  }

  GltfDocument& document_;
  const GltfMeshes& meshes_;
  const GltfShapes& shapes_;
  std::size_t count_;
  std::map<std::size_t, std::vector<std::size_t>> parts_of_;  ///< of a node (1.0) or mesh (0.x)
  std::vector<document::Expression> result_;
  std::set<std::string> names_;
  std::size_t unused_ = 0;
  std::size_t bad_ = 0;
  std::size_t more_ = 0;
  bool colours_ = false;
};

}  // namespace

std::vector<document::Expression> read_expressions(GltfDocument& document, const GltfMeshes& meshes,
                                                   const GltfShapes& shapes, std::size_t count) {
  return Expressions(document, meshes, shapes, count).read();
}

}  // namespace penpose::io
