#include "core/io/gltf/write/patch_gltf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "core/geometry/rotation.h"
#include "core/io/gltf/internal/animation_hash.h"
#include "core/io/gltf/internal/gltf_extras.h"
#include "core/io/gltf/read/internal/gltf_accessor.h"
#include "core/io/gltf/read/internal/gltf_document.h"
#include "core/io/gltf/write/internal/glb_animations.h"
#include "core/io/gltf/write/internal/patch_container.h"
#include "core/io/gltf/write/internal/patch_targets.h"

namespace penpose::io {
namespace {

using document::SourceFile;

bool is_object(const json::Json* value) { return value != nullptr && value->is_object(); }

/// The member "penpose" of an object's extras, made where it is not there. Extras that are no object give way to it.
json::Json& own_extras_of(json::Json& object) {
  if (!is_object(json::find(object, "extras"))) object["extras"] = json::Json::object();
  json::Json& extras = object["extras"];
  if (!is_object(json::find(extras, k_extras_key))) extras[k_extras_key] = json::Json::object();
  return extras[k_extras_key];
}

/// The old entries of a list and others where there are new columns.
json::Json with_columns(const json::Json& list, const MeshTargets& mesh, const json::Json& fresh) {
  json::Json result = json::Json::array();
  for (const TargetColumn& column : mesh.columns) {
    result.push_back(column.old && *column.old < list.size() ? list[*column.old] : fresh);
  }
  return result;
}

/// Whether a skeleton is that of the file and one joint more, at the origin, for all vertices that none carried: a head
/// that moves as a whole (document::with_placements).
bool carries_the_rest(const rig::Skeleton& now, const rig::Skeleton* was) {
  const auto joints = now.joints();
  const std::size_t old = was == nullptr ? 0 : was->joints().size();
  if (joints.size() != old + 1) return false;
  const rig::Joint& added = joints.back();
  if (added.parent >= 0 || added.posable || added.translation != glm::dvec3(0) || added.scale != glm::dvec3(1) ||
      added.rest_rotation != glm::dquat(1, 0, 0, 0) || added.inverse_bind != glm::dmat4(1))
    return false;
  for (std::size_t j = 0; j < old; ++j) {
    const rig::Joint& a = joints[j];
    const rig::Joint& b = was->joints()[j];
    if (a.name != b.name || a.parent != b.parent || a.translation != b.translation || a.scale != b.scale ||
        a.rest_rotation != b.rest_rotation || a.inverse_bind != b.inverse_bind || a.posable != b.posable)
      return false;
  }
  for (std::uint32_t v = 0; v < now.vertex_count(); ++v) {
    const auto a = now.influences_of(v);
    const auto b = was == nullptr ? std::span<const rig::Influence>() : was->influences_of(v);
    if (b.empty() ? a.size() != 1 || a[0].joint != old || a[0].weight != 1.0
                  : !std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
                      return x.joint == y.joint && x.weight == y.weight;
                    }))
      return false;
  }
  return true;
}

class Patch {
 public:
  Patch(const document::Model& model, const WriteOptions& options, const json::Json& project, GltfContainer container,
        GltfDocument& document, const RootExtras& root)
      : model_(model),
        source_(*model.source),
        options_(options),
        project_(project),
        container_(container),
        document_(document),
        root_(root),
        morphs_(model, options.bake_tolerance),
        targets_(model, morphs_, document, root),
        layout_(*model.source, document, container, options.stem),
        builder_(layout_.document(), layout_.buffer(), layout_.start()) {
    builder_.reuse(layout_.known());
  }

  base::Result<PatchedGltf> write() {
    compare_animations();
    find_weights();
    PatchedGltf patched;
    patched.cannot = targets_.cannot();
    if (!patched.cannot.empty()) return patched;
    if (model_.skeleton != source_.skeleton && !write_carrier()) {
      patched.cannot = "its joints are others";
      return patched;
    }
    write_targets();
    write_pose();
    write_joints();
    write_animations();
    write_root();
    const double size = morphs_.size();
    patched.report.targets = weights_->targets().size();
    patched.report.baked = morphs_.all().size() - morphs_.own_count();
    patched.report.bake_error = morphs_.bake_error() + (size > 0 ? between_error_ / size : 0.0);
    auto bytes = layout_.finish(builder_, changed_, patched.report.files);
    if (!bytes) return bytes.error();
    patched.bytes = std::move(bytes).value();
    return patched;
  }

 private:
  /// What becomes of an animation of the model.
  struct Fate {
    std::optional<std::size_t> from;  ///< of SourceFile::animations
    bool kept = false;                ///< its keys stay as they are in the file
  };

  [[nodiscard]] std::size_t width() const { return document::weight_count(model_); }

  void compare_animations() {
    std::vector<std::string> names;
    for (std::size_t w = 0; w < width(); ++w) names.push_back(model_.rig->parameters()[w].name);
    const bool corrected = corrections_of(model_.corrections) != corrections_of(source_.corrections);
    std::vector<bool> taken(source_.animations.size(), false);
    for (const document::Animation& animation : model_.animations) {
      Fate& fate = fates_.emplace_back();
      const base::Hash128 hash = hash_animation(animation, names);
      for (std::size_t i = 0; i < taken.size() && !fate.from; ++i) {
        if (!taken[i] && source_.animations[i].hash == hash && source_.animations[i].name == animation.name)
          fate.from = i;
      }
      fate.kept = fate.from && !(corrected && moves_weights(animation)) && !moves_any(animation, targets_.reshaped());
      if (fate.from) taken[*fate.from] = true;
    }
    for (std::size_t a = 0; a < fates_.size(); ++a) {
      for (std::size_t i = 0; i < taken.size() && !fates_[a].from; ++i) {
        if (taken[i] || source_.animations[i].name != model_.animations[a].name) continue;
        fates_[a].from = i;
        taken[i] = true;
      }
    }
    for (std::size_t i = 0; i < taken.size(); ++i) {
      if (!taken[i]) removed_.insert(source_.animations[i].index);
    }
  }

  static std::vector<articulation::CorrectionSketch> corrections_of(
      const std::shared_ptr<const articulation::Corrections>& corrections) {
    std::vector<articulation::CorrectionSketch> sketches;
    for (std::size_t i = 0; corrections && i < corrections->size(); ++i) {
      sketches.push_back(corrections->all()[i]->drawn);
    }
    return sketches;
  }
  static bool moves_weights(const document::Animation& animation) {
    return std::any_of(animation.channels.begin(), animation.channels.end(),
                       [](const auto& channel) { return channel.target == document::ChannelTarget::weights; });
  }
  [[nodiscard]] bool moves_any(const document::Animation& animation, const std::vector<bool>& columns) const {
    for (const document::Channel& channel : animation.channels) {
      if (channel.target != document::ChannelTarget::weights) continue;
      for (std::size_t i = 0; i < channel.values.size(); ++i) {
        if (columns[i % width()] && channel.values[i] != 0.0) return true;
      }
    }
    return false;
  }

  void find_weights() {
    rewritten_ = model_;
    rewritten_.animations.clear();
    for (std::size_t a = 0; a < fates_.size(); ++a) {
      if (!fates_[a].kept) rewritten_.animations.push_back(model_.animations[a]);
    }
    std::vector<bool> posed(morphs_.all().size(), true);
    for (std::size_t w = 0; w < width(); ++w) posed[w] = targets_.is_posed(w);
    weights_.emplace(rewritten_, morphs_, posed);
    std::vector<bool> used = posed;
    for (std::size_t w = 0; w < width(); ++w) {
      std::vector<bool> one(width(), false);
      one[w] = true;
      used[w] = used[w] || std::any_of(rewritten_.animations.begin(), rewritten_.animations.end(),
                                       [&](const auto& animation) { return moves_any(animation, one); });
    }
    posed_ = std::move(posed);
    targets_.add_new(*weights_, used);
  }

  void write_targets() {
    const std::size_t shapes = model_.shapes ? model_.shapes->shapes().size() : 0;
    TargetWriter writer(model_, document_, builder_);
    for (const MeshTargets& mesh : targets_.meshes()) {
      if (mesh.same()) continue;
      changed_ = true;
      json::Json& object = builder_.root["meshes"][mesh.mesh];
      const std::size_t count = object["primitives"].size();
      std::vector<std::optional<std::size_t>> part_of(count);
      for (const std::size_t part : mesh.parts) {
        for (const std::size_t primitive : source_.parts[part].primitives) part_of[primitive] = part;
      }
      std::vector<json::Json> lists(count, json::Json::array());
      for (const TargetColumn& column : mesh.columns) {
        std::map<std::size_t, json::Json> of_part;
        for (std::size_t p = 0; p < count; ++p) {
          if (!column.fresh) {
            const json::Json* old = json::find(object["primitives"][p], "targets");
            if (old != nullptr && *column.old < old->size()) lists[p].push_back((*old)[*column.old]);
            continue;
          }
          if (!part_of[p]) {
            lists[p].push_back(still_target(object["primitives"][p]));
            continue;
          }
          const auto [at, is_new] = of_part.try_emplace(*part_of[p]);
          if (is_new) {
            at->second = writer.write(*weights_->targets()[column.target], is_made(column.target, shapes), *part_of[p]);
          }
          lists[p].push_back(at->second);
        }
      }
      for (std::size_t p = 0; p < count; ++p) {
        json::Json& primitive = object["primitives"][p];
        if (!lists[p].empty()) {
          primitive["targets"] = std::move(lists[p]);
        } else if (primitive.contains("targets")) {
          primitive.erase("targets");
        }
      }
      name_targets(mesh, object);
      if (mesh.same_columns()) continue;
      fit_weights(mesh, object);
      fit_samplers(mesh);
    }
  }
  /// Whether a target was made for a sketched control, so that its normals follow from its positions.
  [[nodiscard]] bool is_made(std::size_t target, std::size_t shapes) const {
    return target >= shapes && target < morphs_.all().size();
  }
  /// The target of lines and points, which follow no control.
  json::Json still_target(const json::Json& primitive) {
    const json::Json* position = json::find(primitive["attributes"], "POSITION");
    if (position == nullptr) return json::Json::object();
    const auto count = builder_.root["accessors"][position->get<std::size_t>()]["count"].get<std::size_t>();
    return {{"POSITION", builder_.add_zeros(count, "VEC3", true)}};
  }

  /// Names stand where the file has them, in the extras of the mesh or of its primitives.
  void name_targets(const MeshTargets& mesh, json::Json& object) {
    const auto names_of = [](const json::Json& of) -> const json::Json* {
      const json::Json* extras = json::find(of, "extras");
      const json::Json* names = extras == nullptr ? nullptr : json::find(*extras, "targetNames");
      return names != nullptr && names->is_array() ? names : nullptr;
    };
    const auto renamed = [&](const json::Json& old) {
      json::Json names = json::Json::array();
      for (const TargetColumn& column : mesh.columns) {
        const bool has = column.old && *column.old < old.size();
        names.push_back(has ? old[*column.old] : json::Json(column.name));
      }
      return names;
    };
    bool in_primitives = false;
    for (std::size_t p = 0; p < object["primitives"].size(); ++p) {
      json::Json& primitive = object["primitives"][p];
      const json::Json* names = names_of(primitive);
      if (names == nullptr) continue;
      in_primitives = true;
      primitive["extras"]["targetNames"] = renamed(*names);
    }
    const json::Json* names = names_of(object);
    if (names == nullptr && in_primitives) return;
    json::Json made = renamed(names == nullptr ? json::Json::array() : *names);
    if (!is_object(json::find(object, "extras"))) object["extras"] = json::Json::object();
    object["extras"]["targetNames"] = std::move(made);
  }

  /// Weights of meshes and nodes are as many as the targets.
  void fit_weights(const MeshTargets& mesh, json::Json& object) {
    const auto fit = [&](json::Json& holder) {
      if (!holder.contains("weights") || holder["weights"].empty()) return;
      json::Json weights = with_columns(holder["weights"], mesh, 0);
      if (weights.empty()) {
        holder.erase("weights");
      } else {
        holder["weights"] = std::move(weights);
      }
    };
    fit(object);
    for (std::size_t n = 0; n < document_.model.nodes.size(); ++n) {
      if (document_.model.nodes[n].mesh == static_cast<int>(mesh.mesh)) fit(builder_.root["nodes"][n]);
    }
  }

  /// Keys of weights of a mesh get the columns of its targets; samplers that serve other nodes, too, are copied.
  void fit_samplers(const MeshTargets& mesh) {
    if (mesh.old_count == 0) return;
    std::map<int, std::size_t> outputs;  // accessor of the file and what it has become
    for (std::size_t a = 0; a < document_.model.animations.size(); ++a) {
      const tinygltf::Animation& animation = document_.model.animations[a];
      const auto is_of_mesh = [&](const tinygltf::AnimationChannel& channel) {
        return channel.target_path == "weights" && channel.target_node >= 0 &&
               document_.model.nodes[static_cast<std::size_t>(channel.target_node)].mesh == static_cast<int>(mesh.mesh);
      };
      std::map<int, std::size_t> copies;
      for (std::size_t c = 0; c < animation.channels.size(); ++c) {
        const tinygltf::AnimationChannel& channel = animation.channels[c];
        if (!is_of_mesh(channel)) continue;
        const auto [copy, is_new] = copies.try_emplace(channel.sampler, static_cast<std::size_t>(channel.sampler));
        json::Json& object = builder_.root["animations"][a];
        if (is_new) {
          const bool shared = std::any_of(animation.channels.begin(), animation.channels.end(), [&](const auto& other) {
            return other.sampler == channel.sampler && !is_of_mesh(other);
          });
          if (shared) {
            object["samplers"].push_back(json::Json(object["samplers"][channel.sampler]));
            copy->second = object["samplers"].size() - 1;
          }
          fit_sampler(mesh, animation.samplers[static_cast<std::size_t>(channel.sampler)].output,
                      object["samplers"][copy->second], outputs);
        }
        object["channels"][c]["sampler"] = copy->second;
      }
    }
  }

  template <typename Value>
  std::vector<Value> fit_rows(const MeshTargets& mesh, const std::vector<Value>& old) {
    std::vector<Value> values;
    for (std::size_t row = 0; row + mesh.old_count <= old.size(); row += mesh.old_count) {
      for (const TargetColumn& column : mesh.columns) values.push_back(column.old ? old[row + *column.old] : Value{});
    }
    return values;
  }

  void fit_sampler(const MeshTargets& mesh, int output, json::Json& sampler, std::map<int, std::size_t>& outputs) {
    const auto found = outputs.find(output);
    if (found == outputs.end()) {
      const auto elements = read_elements(document_, output, {.type = TINYGLTF_TYPE_SCALAR});
      if (!elements || elements->count == 0 || elements->count % mesh.old_count != 0) return;
      outputs[output] = builder_.add_floats(fit_rows(mesh, elements->dense()), "SCALAR", BufferUse::plain, false);
    }
    sampler["output"] = outputs[output];
    const json::Json* extras = json::find(sampler, "extras");
    const json::Json* own = extras == nullptr ? nullptr : json::find(*extras, k_extras_key);
    const json::Json* spline = own == nullptr ? nullptr : json::find(*own, "spline");
    const json::Json* values = spline == nullptr ? nullptr : json::find(*spline, "values");
    if (values == nullptr || !values->is_array()) return;
    std::vector<json::Json> old;
    for (const json::Json& value : *values) old.push_back(value);
    json::Json fitted = json::Json::array();
    for (json::Json& value : fit_rows(mesh, old)) fitted.push_back(value.is_null() ? json::Json(0) : std::move(value));
    sampler["extras"][k_extras_key]["spline"]["values"] = std::move(fitted);
  }

  void write_pose() {
    for (const MeshTargets& mesh : targets_.meshes()) {
      const auto& nodes = document_.model.nodes;
      const bool shared = std::count_if(nodes.begin(), nodes.end(),
                                        [&](const auto& node) { return node.mesh == static_cast<int>(mesh.mesh); }) > 1;
      for (const std::size_t node : mesh.nodes) {
        for (std::size_t c = 0; c < mesh.columns.size(); ++c) {
          const auto weight = weight_to_write(mesh, node, c);
          if (weight) set_weight(mesh, node, c, *weight, shared);
        }
      }
    }
  }
  /// None: it stays what it is in the file.
  std::optional<double> weight_to_write(const MeshTargets& mesh, std::size_t node, std::size_t c) {
    const TargetColumn& column = mesh.columns[c];
    std::size_t target = column.target;
    if (mesh.nodes.size() > 1 && column.old) {
      for (const SourceFile::Part& part : source_.parts) {
        if (part.node != node || *column.old >= part.targets.size()) continue;
        target = target_named(part.targets[*column.old]);
        break;
      }
    }
    const std::string helped = target >= morphs_.all().size() ? base_of(column.name) : std::string();
    if (target == k_no_target && helped.empty()) return std::nullopt;
    if (target < width()) return posed_[target] || !column.old ? std::optional(posed_weight(target)) : std::nullopt;
    if (target < morphs_.all().size()) return weights_->posed(target);
    // One that takes a part of the weight of another.
    const std::size_t base = target_named(helped);
    if (base < width() && !posed_[base]) return column.old ? std::nullopt : std::optional(0.0);
    return target == k_no_target ? 0.0 : weights_->posed(target);
  }
  /// A control that was not posed has no other targets that help it.
  [[nodiscard]] double posed_weight(std::size_t target) const {
    return posed_[target] ? weights_->posed(target) : model_.pose[target];
  }
  [[nodiscard]] std::size_t target_named(const std::string& name) const {
    const auto all = morphs_.all();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const auto* one) { return one->parameter.name == name; });
    return found == all.end() ? k_no_target : static_cast<std::size_t>(found - all.begin());
  }
  [[nodiscard]] std::string base_of(const std::string& helper) const {
    for (const OneWayName& one : targets_.one_way_names(*weights_)) {
      if (one.target == helper) return one.name;
    }
    return {};
  }
  void set_weight(const MeshTargets& mesh, std::size_t node, std::size_t column, double weight, bool shared) {
    json::Json& object = builder_.root["meshes"][mesh.mesh];
    json::Json& holder = builder_.root["nodes"][node];
    const json::Json* own = json::find(holder, "weights");
    const bool has_own = own != nullptr && !own->empty();
    const json::Json* now = has_own ? own : json::find(object, "weights");
    const double is = now != nullptr && column < now->size() ? (*now)[column].get<double>() : 0.0;
    if (is == weight) return;
    changed_ = true;
    json::Json list = now == nullptr ? json::Json::array() : *now;
    while (list.size() < mesh.columns.size()) list.push_back(0);
    list[column] = weight;
    (has_own || shared ? holder : object)["weights"] = std::move(list);
  }

  /// A node above all parts that no joint carried. False: joints are below the same root.
  bool write_carrier() {
    const auto& nodes = document_.model.nodes;
    std::vector<std::optional<std::size_t>> parent(nodes.size());
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      for (const int child : nodes[n].children) parent[static_cast<std::size_t>(child)] = n;
    }
    std::set<std::size_t> roots;
    std::set<std::size_t> between;
    for (std::size_t p = 0; p < source_.parts.size(); ++p) {
      const mesh::Part& part = model_.mesh->parts()[p];
      if (part.vertex_count == 0) continue;
      const auto influences = model_.skeleton->influences_of(part.first_vertex);
      if (influences.size() != 1 || influences[0].joint != source_.nodes.size()) continue;
      std::size_t node = source_.parts[p].node;
      for (between.insert(node); parent[node]; between.insert(node)) node = *parent[node];
      roots.insert(node);
    }
    for (const auto& joint : source_.nodes) {
      if (!joint) continue;
      std::size_t node = *joint;
      while (parent[node]) node = *parent[node];
      if (roots.contains(node)) return false;
    }
    changed_ = true;
    for (const std::size_t node : between) own_extras_of(builder_.root["nodes"][node])["carried_by_parent"] = true;
    json::Json made = {{"name", model_.skeleton->joints().back().name},
                       {"children", std::vector<std::size_t>(roots.begin(), roots.end())}};
    json::Json& own = own_extras_of(made);
    own["joint"] = true;
    own["posable"] = false;
    carrier_ = builder_.add("nodes", std::move(made));
    const std::size_t scenes = builder_.root.contains("scenes") ? builder_.root["scenes"].size() : 0;
    for (std::size_t i = 0; i < scenes; ++i) {
      const json::Json* list = json::find(builder_.root["scenes"][i], "nodes");
      if (list == nullptr) continue;
      json::Json left = json::Json::array();
      bool has = false;
      for (const json::Json& node : *list) {
        const bool goes = roots.contains(node.get<std::size_t>());
        if (!goes || !has) left.push_back(goes ? json::Json(*carrier_) : node);
        has = has || goes;
      }
      builder_.root["scenes"][i]["nodes"] = std::move(left);
    }
    return true;
  }

  void write_joints() {
    if (!model_.skeleton) return;
    std::size_t parameter = width();
    for (std::size_t j = 0; j < model_.skeleton->joints().size(); ++j) {
      const rig::Joint& joint = model_.skeleton->joints()[j];
      if (!joint.posable) continue;
      glm::dvec3 angles(0);
      bool posed = false;
      for (int axis = 0; axis < 3; ++axis, ++parameter) {
        angles[axis] = model_.pose[parameter];
        const auto was = source_.pose.find(model_.rig->parameters()[parameter].name);
        posed = posed || was == source_.pose.end() || was->second != angles[axis];
      }
      if (posed && source_.nodes[j]) write_joint(joint, angles, builder_.root["nodes"][*source_.nodes[j]]);
    }
  }
  void write_joint(const rig::Joint& joint, const glm::dvec3& angles, json::Json& node) {
    changed_ = true;
    if (node.contains("matrix")) {
      node.erase("matrix");
      if (joint.translation != glm::dvec3(0)) node["translation"] = list_of(joint.translation);
      if (joint.scale != glm::dvec3(1)) node["scale"] = list_of(joint.scale);
    }
    glm::dquat rotation = joint.rest_rotation;
    if (angles != glm::dvec3(0)) rotation = rotation * geometry::quaternion_from_xyz(angles);
    const double length = std::sqrt(glm::dot(rotation, rotation));
    if (std::abs(length - 1.0) > 1e-12) rotation = rotation / length;
    node["rotation"] = json::Json::array({rotation.x, rotation.y, rotation.z, rotation.w});
    json::Json& own = own_extras_of(node);
    own["values"] = list_of(angles);
    const glm::dquat& rest = joint.rest_rotation;
    own["rest_rotation"] = json::Json::array({rest.x, rest.y, rest.z, rest.w});
  }
  static json::Json list_of(const glm::dvec3& v) { return json::Json::array({v.x, v.y, v.z}); }

  [[nodiscard]] std::vector<WeightNode> weight_nodes() {
    std::vector<WeightNode> nodes;
    for (const MeshTargets& mesh : targets_.meshes()) {
      for (const std::size_t node : mesh.nodes) {
        if (mesh.columns.empty()) continue;
        WeightNode& made = nodes.emplace_back(WeightNode{node, {}});
        for (const TargetColumn& column : mesh.columns) {
          std::size_t target = column.target;
          if (mesh.nodes.size() > 1 && column.old) {
            for (const SourceFile::Part& part : source_.parts) {
              if (part.node == node && *column.old < part.targets.size()) {
                target = target_named(part.targets[*column.old]);
                break;
              }
            }
          }
          made.targets.push_back(target);
        }
      }
    }
    return nodes;
  }

  void write_animations() {
    const std::vector<WeightNode> nodes = weight_nodes();
    const auto node_of_joint = [&](std::size_t joint) {
      return joint < source_.nodes.size() ? source_.nodes[joint] : carrier_;
    };
    GlbAnimations writer(*weights_, nodes, node_of_joint, builder_);
    std::vector<std::size_t> order;
    std::size_t rewritten = 0;
    for (std::size_t a = 0; a < fates_.size(); ++a) {
      const Fate& fate = fates_[a];
      if (fate.kept) {
        order.push_back(source_.animations[*fate.from].index);
        continue;
      }
      const document::Animation& animation = rewritten_.animations[rewritten++];
      json::Json object = json::Json::object();
      json::Json channels = json::Json::array();
      json::Json samplers = json::Json::array();
      if (fate.from) {
        const std::size_t index = source_.animations[*fate.from].index;
        object = builder_.root["animations"][index];
        keep_channels(object, index, nodes, channels, samplers);
      }
      writer.write(animation, channels, samplers);
      if (channels.empty()) continue;
      changed_ = true;
      object["channels"] = std::move(channels);
      object["samplers"] = std::move(samplers);
      if (!animation.name.empty()) object["name"] = animation.name;
      const double fps = GlbAnimations::rate_of(animation);
      if (fps > 0) own_extras_of(object)["fps"] = fps;
      if (fate.from) {
        const std::size_t index = source_.animations[*fate.from].index;
        builder_.root["animations"][index] = std::move(object);
        order.push_back(index);
      } else {
        order.push_back(builder_.add("animations", std::move(object)));
      }
    }
    between_error_ = writer.between_error();
    remove_animations(order);
    for (std::size_t i = 1; i < order.size(); ++i) {
      if (order[i] < order[i - 1]) order_ = order;
    }
  }
  /// Channels of an animation that the model does not have: of nodes that are no joints, of what extensions drive.
  void keep_channels(const json::Json& object, std::size_t index, const std::vector<WeightNode>& nodes,
                     json::Json& channels, json::Json& samplers) {
    const auto& all = document_.model.animations[index].channels;
    for (std::size_t c = 0; c < all.size() && c < object["channels"].size(); ++c) {
      const bool of_model =
          all[c].target_path == "weights"
              ? std::any_of(nodes.begin(), nodes.end(),
                            [&](const auto& one) { return static_cast<int>(one.node) == all[c].target_node; })
              : std::any_of(source_.nodes.begin(), source_.nodes.end(),
                            [&](const auto& one) { return one && static_cast<int>(*one) == all[c].target_node; });
      if (of_model) continue;
      json::Json channel = object["channels"][c];
      samplers.push_back(object["samplers"][channel["sampler"].get<std::size_t>()]);
      channel["sampler"] = samplers.size() - 1;
      channels.push_back(std::move(channel));
    }
  }
  void remove_animations(std::vector<std::size_t>& order) {
    if (removed_.empty()) return;
    changed_ = true;
    json::Json left = json::Json::array();
    std::map<std::size_t, std::size_t> place;
    const json::Json& all = builder_.root["animations"];
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (removed_.contains(i)) continue;
      place[i] = left.size();
      left.push_back(all[i]);
    }
    for (std::size_t& index : order) index = place[index];
    if (left.empty()) {
      builder_.root.erase("animations");
    } else {
      builder_.root["animations"] = std::move(left);
    }
  }

  [[nodiscard]] bool same_parameters() const {
    if (static_cast<bool>(model_.shapes) != static_cast<bool>(source_.shapes)) return false;
    if (!model_.shapes) return true;
    const auto now = model_.shapes->parameters();
    const auto was = source_.shapes->parameters();
    return std::equal(now.begin(), now.end(), was.begin(), was.end(), [](const auto& a, const auto& b) {
      return a.name == b.name && a.rest == b.rest && a.minimum == b.minimum && a.maximum == b.maximum;
    });
  }

  void write_root() {
    json::Json made =
        write_root_extras(model_, morphs_.baked_names(), targets_.one_way_names(*weights_), project_)[k_extras_key];
    if (!order_.empty()) made["animation_order"] = json::Json(order_);
    const json::Json* extras = json::find(builder_.root, "extras");
    const json::Json* own = extras == nullptr ? nullptr : json::find(*extras, k_extras_key);
    const bool needed = changed_ || !project_.is_null() || model_.deformers || model_.corrections ||
                        !model_.curves.empty() || !same_parameters();
    if (own != nullptr ? *own == made : !needed) return;
    changed_ = true;
    own_extras_of(builder_.root) = std::move(made);
  }

  const document::Model& model_;
  const SourceFile& source_;
  const WriteOptions& options_;
  const json::Json& project_;
  GltfContainer container_;
  GltfDocument& document_;
  const RootExtras& root_;
  GlbTargets morphs_;
  PatchTargets targets_;
  PatchContainer layout_;
  GltfBuilder builder_;
  std::optional<GlbWeights> weights_;
  document::Model rewritten_;  ///< with the animations that are written again alone
  std::vector<Fate> fates_;    ///< one an animation of the model
  std::set<std::size_t> removed_;
  std::vector<bool> posed_;  ///< one a target of morphs_
  std::vector<std::size_t> order_;
  std::optional<std::size_t> carrier_;  ///< the node that carries what no joint of the file does
  double between_error_ = 0;            ///< model units
  bool changed_ = false;
};

}  // namespace

base::Result<PatchedGltf> patch_gltf(const document::Model& model, const WriteOptions& options,
                                     const json::Json& project, GltfContainer container) {
  const SourceFile& source = *model.source;
  const auto cannot = [](std::string why) {
    PatchedGltf none;
    none.cannot = std::move(why);
    return none;
  };
  if (model.mesh != source.mesh) return cannot("its surface is another one");
  if (model.skeleton != source.skeleton &&
      !(model.skeleton && carries_the_rest(*model.skeleton, source.skeleton.get())))
    return cannot("its joints are others");
  auto opened = open_gltf(*source.bytes, resolver_of(source));
  if (!opened) return cannot(opened.error().what);
  const auto root = read_root_extras(opened->json);
  if (!root) return cannot(root.error().what);
  return Patch(model, options, project, container, *opened, *root).write();
}

std::string lost_without_source(const document::Model& model) {
  const auto opened = open_gltf(*model.source->bytes, resolver_of(*model.source));
  if (!opened) return {};
  std::vector<std::string> lost;
  const auto has = [&](const char* name) {
    const json::Json* list = json::find(opened->json, name);
    return list != nullptr && !list->empty();
  };
  const auto has_attribute = [&](std::string_view prefix) {
    for (const auto& mesh : opened->model.meshes) {
      for (const auto& primitive : mesh.primitives) {
        for (const auto& [name, accessor] : primitive.attributes) {
          if (name.starts_with(prefix)) return true;
        }
      }
    }
    return false;
  };
  if (has("textures") || has("images")) lost.emplace_back("textures");
  if (has_attribute("TEXCOORD_")) lost.emplace_back("texture coordinates");
  if (has_attribute("COLOR_")) lost.emplace_back("vertex colours");
  if (has_attribute("TANGENT")) lost.emplace_back("tangents");
  if (has("cameras")) lost.emplace_back("cameras");
  if (has("extensionsUsed")) lost.emplace_back("extensions");
  std::string text;
  for (const std::string& one : lost) text += (text.empty() ? "" : ", ") + one;
  return text;
}

}  // namespace penpose::io
