#include "core/io/gltf/read/internal/gltf_expressions.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/text/utf8.h"
#include "core/io/text/names.h"

namespace penpose::io {
namespace {

/// More than any avatar has; a hostile file must not make each byte unfold to a whole shape.
constexpr std::size_t k_most_expressions = 200;

class Expressions {
 public:
  Expressions(GltfDocument& document, const GltfMeshes& meshes, GltfShapes& shapes)
      : document_(document), meshes_(meshes), shapes_(shapes) {}

  void read() {
    const json::Json* extensions = json::find(document_.json, "extensions");
    if (extensions == nullptr) return;
    if (const json::Json* vrm = json::find(*extensions, "VRMC_vrm")) read_vrm1(*vrm);
    if (const json::Json* vrm = json::find(*extensions, "VRM")) read_vrm0(*vrm);
    if (more_ > 0) document_.notes.push_back("and " + std::to_string(more_) + " binds more are left out");
    if (colours_) document_.notes.emplace_back("expressions change materials too; that is left out");
  }

 private:
  using Moves = std::map<std::uint32_t, glm::vec3>;

  void read_vrm1(const json::Json& vrm) {
    const json::Json* expressions = json::find(vrm, "expressions");
    for (const char* group : {"preset", "custom"}) {
      const json::Json* members = expressions == nullptr ? nullptr : json::find(*expressions, group);
      if (members == nullptr || !members->is_object()) continue;
      for (const auto& [name, expression] : members->items()) {
        Moves moves;
        const json::Json* binds = json::find(expression, "morphTargetBinds");
        add_binds(binds, name, "node", 1.0, moves);
        for (const char* other : {"materialColorBinds", "textureTransformBinds"}) {
          const json::Json* list = json::find(expression, other);
          colours_ = colours_ || (list != nullptr && list->is_array() && !list->empty());
        }
        add_shape(name, binds, moves);
      }
    }
  }

  void read_vrm0(const json::Json& vrm) {
    const json::Json* master = json::find(vrm, "blendShapeMaster");
    const json::Json* groups = master == nullptr ? nullptr : json::find(*master, "blendShapeGroups");
    if (groups == nullptr || !groups->is_array()) return;
    for (const json::Json& group : *groups) {
      Moves moves;
      const std::string name = name_of(group);
      const json::Json* binds = json::find(group, "binds");
      // Weights of VRM 0 are percent.
      add_binds(binds, name.empty() ? "without a name" : name, "mesh", 0.01, moves);
      const json::Json* materials = json::find(group, "materialValues");
      colours_ = colours_ || (materials != nullptr && materials->is_array() && !materials->empty());
      if (!name.empty()) add_shape(name, binds, moves);
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
  void add_binds(const json::Json* binds, const std::string& name, const char* key, double scale, Moves& moves) {
    constexpr std::size_t k_most_notes = 20;
    for (std::size_t i = 0; binds != nullptr && binds->is_array() && i < binds->size(); ++i) {
      const std::string problem = add_bind((*binds)[i], key, scale, moves);
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
  std::string add_bind(const json::Json& bind, const char* key, double scale, Moves& moves) {
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
    bool there = false;
    bool found = false;
    for (std::size_t i = 0; i < meshes_.origins.size(); ++i) {
      const PartOrigin& origin = meshes_.origins[i];
      const auto own = static_cast<std::int64_t>(key[0] == 'n' ? origin.node : origin.mesh);
      const auto& targets = shapes_.of_target[i];
      there = there || own == owner_number;
      if (own != owner_number || static_cast<std::size_t>(target) >= targets.size()) continue;
      found = true;
      const rig::BlendShape& shape = shapes_.shapes[targets[static_cast<std::size_t>(target)]];
      const mesh::Part& part = meshes_.source.parts[i];
      const auto begin = std::lower_bound(shape.vertices.begin(), shape.vertices.end(), part.first_vertex);
      for (auto v = begin; v != shape.vertices.end() && *v < part.first_vertex + part.vertex_count; ++v) {
        if (document_.budget == 0) return "the file unfolds to more than can be kept";
        --document_.budget;
        moves[*v] += shape.deltas[static_cast<std::size_t>(v - shape.vertices.begin())] * static_cast<float>(weight);
      }
    }
    if (found) return {};
    return owned_by + (there ? " has no morph target " + std::to_string(target) : " is not there or shows nothing");
  }

  void add_shape(const std::string& name, const json::Json* binds, const Moves& moves) {
    const std::string valid = base::valid_utf8(name);
    // Those without binds are common: they change colours, or nothing at all.
    const bool binds_any = binds != nullptr && binds->is_array() && !binds->empty();
    if (added_ == k_most_expressions || (moves.empty() && binds_any)) {
      ++unused_;
      if (unused_ <= 20) {
        document_.notes.push_back("expression " + valid +
                                  " is left out: " + (moves.empty() ? "it moves no vertex" : "there are over 200"));
      }
    }
    if (moves.empty() || added_ == k_most_expressions) return;
    const bool taken = std::any_of(shapes_.shapes.begin(), shapes_.shapes.end(),
                                   [&](const rig::BlendShape& shape) { return shape.parameter.name == valid; });
    if (taken) {
      document_.notes.push_back("expression " + valid + " is left out: a morph target has its name");
      return;
    }
    ++added_;
    rig::BlendShape& shape = shapes_.shapes.emplace_back();
    shape.parameter.name = valid;
    for (const auto& [vertex, delta] : moves) {
      shape.vertices.push_back(vertex);
      shape.deltas.push_back(delta);
    }
    shapes_.values.push_back(0.0);
  }

  GltfDocument& document_;
  const GltfMeshes& meshes_;
  GltfShapes& shapes_;
  std::size_t added_ = 0;
  std::size_t unused_ = 0;
  std::size_t bad_ = 0;
  std::size_t more_ = 0;
  bool colours_ = false;
};

}  // namespace

void add_expressions(GltfDocument& document, const GltfMeshes& meshes, GltfShapes& shapes) {
  Expressions(document, meshes, shapes).read();
}

}  // namespace penpose::io
