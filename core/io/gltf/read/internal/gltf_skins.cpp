#include "core/io/gltf/read/internal/gltf_skins.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <queue>
#include <set>

#include "core/io/gltf/read/internal/gltf_accessor.h"
#include "core/io/remedies.h"
#include "core/io/text/names.h"

namespace penpose::io {
namespace {

constexpr std::int32_t k_no_joint = -1;
/// Joints of a skin that stand for nothing: vertices that follow them have no influence.
constexpr std::uint32_t k_still = 0xffffffffU;

class SkeletonReader {
 public:
  SkeletonReader(GltfDocument& document, const NodeTree& tree, const GltfMeshes& meshes,
                 const std::vector<NodeExtras>& extras)
      : document_(document), tree_(tree), meshes_(meshes), extras_(extras) {}

  base::Result<GltfSkeleton> read() {
    for (std::size_t i = 0; i < meshes_.origins.size(); ++i) {
      const std::int32_t skin = skin_of(i);
      if (skin == k_no_joint || !document_.model.skins[static_cast<std::size_t>(skin)].joints.empty()) continue;
      return base::Error{"the skin has no joints", "/skins/" + std::to_string(skin), k_export_again};
    }
    if (auto status = read_transforms(); !status) return status.error();
    if (sheared_) document_.notes.emplace_back("nodes shear what they carry; it is shown without that");
    find_carriers();
    find_joints();
    if (order_.empty()) {
      result_.joint_of_node = joint_of_node_;
      return std::move(result_);
    }
    if (auto status = make_joints(); !status) return status.error();
    if (auto status = read_skins(); !status) return status.error();
    result_.first_influence.push_back(0);
    for (std::size_t i = 0; i < meshes_.origins.size(); ++i) {
      auto status = skin_of(i) != k_no_joint ? skin_part(i) : carry_part(i);
      if (!status) return status.error();
    }
    if (unweighted_) {
      document_.notes.emplace_back("skinned vertices without weights follow the first joint of their skin");
    }
    if (unfit_ > 0) {
      document_.notes.push_back(
          "weights of skins that are below 0, no numbers or of joints that are not there were left out: " +
          std::to_string(unfit_));
    }
    finish_names();
    result_.joint_of_node = joint_of_node_;
    return std::move(result_);
  }

 private:
  [[nodiscard]] const std::vector<tinygltf::Node>& nodes() const { return document_.model.nodes; }

  /// The skin of a part, if its vertices have weights for it.
  [[nodiscard]] std::int32_t skin_of(std::size_t part) const {
    const PartOrigin& origin = meshes_.origins[part];
    const auto& attributes = origin.primitive(document_).attributes;
    const bool weighted = attributes.contains("JOINTS_0") && attributes.contains("WEIGHTS_0");
    return weighted ? nodes()[origin.node].skin : k_no_joint;
  }

  base::Status read_transforms() {
    // Only transforms that matter have to make sense; a light may shear as it likes.
    transforms_.resize(nodes().size());
    moved_.assign(nodes().size(), false);
    animated_.assign(nodes().size(), false);
    for (const auto& animation : document_.model.animations) {
      for (const auto& channel : animation.channels) {
        if (channel.target_node >= 0 && channel.target_path != "weights") {
          animated_[static_cast<std::size_t>(channel.target_node)] = true;
        }
      }
    }
    std::vector<bool> matters(nodes().size(), false);
    const auto mark = [&](std::size_t node) {
      for (auto n = static_cast<std::int32_t>(node); n != k_no_joint && !matters[static_cast<std::size_t>(n)];
           n = tree_.parent[static_cast<std::size_t>(n)]) {
        matters[static_cast<std::size_t>(n)] = true;
      }
    };
    for (std::size_t i = 0; i < meshes_.origins.size(); ++i) {
      if (skin_of(i) == k_no_joint) mark(meshes_.origins[i].node);
    }
    for (const auto& skin : document_.model.skins) {
      for (const int joint : skin.joints) mark(static_cast<std::size_t>(joint));
    }
    for (std::size_t n = 0; n < extras_.size(); ++n) {
      if (extras_[n].joint) mark(n);
    }
    for (std::size_t n = 0; n < nodes().size(); ++n) {
      if (!matters[n]) continue;
      auto transform = node_transform(document_, n);
      if (!transform) return transform.error();
      sheared_ = sheared_ || transform->sheared;
      NodeTransform at_rest = *transform;
      at_rest.rotation = extras_[n].rest_rotation.value_or(at_rest.rotation);
      moved_[n] = !(at_rest == NodeTransform{});
      transforms_[n] = *transform;
    }
    return base::Done{};
  }

  /// A part without a skin goes with its node, where that is a joint or is not simply the origin.
  void find_carriers() {
    for (std::size_t i = 0; i < meshes_.origins.size(); ++i) {
      auto node = static_cast<std::int32_t>(meshes_.origins[i].node);
      carrier_.push_back(k_no_joint);
      if (skin_of(i) != k_no_joint) continue;
      while (extras_[static_cast<std::size_t>(node)].carried_by_parent &&
             tree_.parent[static_cast<std::size_t>(node)] != k_no_joint) {
        node = tree_.parent[static_cast<std::size_t>(node)];
      }
      bool goes_along = extras_[static_cast<std::size_t>(node)].joint;
      for (auto n = node; n != k_no_joint && !goes_along; n = tree_.parent[static_cast<std::size_t>(n)]) {
        goes_along = moved_[static_cast<std::size_t>(n)] || animated_[static_cast<std::size_t>(n)];
      }
      if (goes_along) carrier_.back() = node;
    }
  }

  void find_joints() {
    std::vector<bool> needed(nodes().size(), false);
    posable_.assign(nodes().size(), false);
    const auto need = [&](std::size_t node) {
      for (auto n = static_cast<std::int32_t>(node); n != k_no_joint && !needed[static_cast<std::size_t>(n)];
           n = tree_.parent[static_cast<std::size_t>(n)]) {
        needed[static_cast<std::size_t>(n)] = true;
      }
    };
    for (std::size_t i = 0; i < meshes_.origins.size(); ++i) {
      const std::int32_t skin = skin_of(i);
      if (skin != k_no_joint) used_skins_.insert(static_cast<std::size_t>(skin));
      if (carrier_[i] == k_no_joint) continue;
      const auto node = static_cast<std::size_t>(carrier_[i]);
      need(node);
      const std::int32_t parent = tree_.parent[node];
      if (meshes_.origins.size() > 1 && parent != k_no_joint && nodes()[static_cast<std::size_t>(parent)].mesh >= 0) {
        posable_[node] = true;
      }
    }
    for (std::size_t s = 0; s < document_.model.skins.size(); ++s) {
      // Our own files may keep joints in a skin that no part uses yet.
      const auto& joints = document_.model.skins[s].joints;
      const bool ours =
          std::any_of(joints.begin(), joints.end(), [&](int j) { return extras_[static_cast<std::size_t>(j)].joint; });
      if (ours) used_skins_.insert(s);
    }
    for (const std::size_t s : used_skins_) {
      for (const int joint : document_.model.skins[s].joints) {
        const auto node = static_cast<std::size_t>(joint);
        if (extras_[node].still) continue;
        need(node);
        posable_[node] = true;
      }
    }
    for (std::size_t n = 0; n < nodes().size(); ++n) {
      if (extras_[n].joint) need(n);
      if (extras_[n].posable) posable_[n] = *extras_[n].posable;
    }
    sort_parents_first(needed);
  }

  void sort_parents_first(const std::vector<bool>& needed) {
    joint_of_node_.assign(nodes().size(), k_no_joint);
    std::priority_queue<std::size_t, std::vector<std::size_t>, std::greater<>> ready;
    for (std::size_t n = 0; n < nodes().size(); ++n) {
      if (needed[n] && tree_.parent[n] == k_no_joint) ready.push(n);
    }
    while (!ready.empty()) {
      const std::size_t node = ready.top();
      ready.pop();
      joint_of_node_[node] = static_cast<std::int32_t>(order_.size());
      order_.push_back(node);
      for (const int c : nodes()[node].children) {
        if (needed[static_cast<std::size_t>(c)]) ready.push(static_cast<std::size_t>(c));
      }
    }
  }

  base::Status make_joints() {
    for (const std::size_t node : order_) {
      const NodeExtras& extras = extras_[node];
      rig::Joint joint;
      joint.name = nodes()[node].name;
      const std::int32_t parent = tree_.parent[node];
      joint.parent = parent == k_no_joint ? k_no_joint : joint_of_node_[static_cast<std::size_t>(parent)];
      joint.translation = transforms_[node].translation;
      joint.rest_rotation = extras.rest_rotation.value_or(transforms_[node].rotation);
      joint.scale = transforms_[node].scale;
      joint.posable = posable_[node];
      joint.minimum = extras.minimum.value_or(joint.minimum);
      joint.maximum = extras.maximum.value_or(joint.maximum);
      for (int axis = 0; axis < 3; ++axis) {
        if (joint.minimum[axis] <= 0.0 && joint.maximum[axis] >= 0.0 && joint.minimum[axis] < joint.maximum[axis])
          continue;
        return base::Error{"the range of the joint has no room for its rest value 0", node_pointer(node) + "/extras",
                           "give minimum <= 0 <= maximum"};
      }
      if (joint.posable) {
        for (int axis = 0; axis < 3; ++axis) {
          result_.values.push_back(std::clamp(extras.values[axis], joint.minimum[axis], joint.maximum[axis]));
        }
      }
      result_.joints.push_back(std::move(joint));
    }
    has_bind_.assign(result_.joints.size(), false);
    return base::Done{};
  }

  /// The joint that takes vertices from `bind` space along with a node. A node may serve skins with several bind
  /// matrices; then joints without a movement of their own hang on it.
  std::uint32_t joint_with_bind(std::size_t node, const glm::dmat4& bind) {
    const auto joint = static_cast<std::uint32_t>(joint_of_node_[node]);
    if (!has_bind_[joint]) {
      has_bind_[joint] = true;
      result_.joints[joint].inverse_bind = bind;
    }
    if (result_.joints[joint].inverse_bind == bind) return joint;
    auto& more = more_binds_[joint];
    for (const std::uint32_t other : more) {
      if (result_.joints[other].inverse_bind == bind) return other;
    }
    rig::Joint extra;
    extra.name = result_.joints[joint].name;
    extra.parent = static_cast<std::int32_t>(joint);
    extra.inverse_bind = bind;
    extra.posable = false;
    more.push_back(static_cast<std::uint32_t>(result_.joints.size()));
    result_.joints.push_back(std::move(extra));
    has_bind_.push_back(true);
    return more.back();
  }

  base::Status read_skins() {
    joints_of_skin_.resize(document_.model.skins.size());
    for (const std::size_t s : used_skins_) {
      const tinygltf::Skin& skin = document_.model.skins[s];
      std::vector<float> binds;
      if (skin.inverseBindMatrices >= 0) {
        const auto elements = read_elements(document_, skin.inverseBindMatrices,
                                            {.type = TINYGLTF_TYPE_MAT4, .float_only = true, .needs_data = true});
        if (!elements) return elements.error();
        if (elements->count < skin.joints.size()) {
          return base::Error{"fewer inverse bind matrices than joints", "/skins/" + std::to_string(s), k_export_again};
        }
        binds = elements->dense();
      }
      for (std::size_t j = 0; j < skin.joints.size(); ++j) {
        const auto node = static_cast<std::size_t>(skin.joints[j]);
        glm::dmat4 bind(1);
        for (int c = 0; c < 4 && !binds.empty(); ++c) {
          for (int r = 0; r < 3; ++r) {
            const double value = binds[16 * j + static_cast<std::size_t>(4 * c + r)];
            if (!(std::abs(value) <= 1e15)) {
              return base::Error{"inverse bind matrix " + std::to_string(j) + " has a number that is no finite length",
                                 accessor_pointer(skin.inverseBindMatrices), k_export_again};
            }
            bind[c][r] = value;
          }
        }
        bind = extras_[node].inverse_bind.value_or(bind);
        joints_of_skin_[s].push_back(extras_[node].still ? k_still : joint_with_bind(node, bind));
      }
    }
    return base::Done{};
  }

  base::Status skin_part(std::size_t index) {
    const auto& attributes = meshes_.origins[index].primitive(document_).attributes;
    const std::size_t count = meshes_.source.parts[index].vertex_count;
    const auto& joints = joints_of_skin_[static_cast<std::size_t>(skin_of(index))];
    struct Set {
      std::vector<float> joints;
      std::vector<float> weights;
    };
    std::vector<Set> sets;
    for (int n = 0;; ++n) {
      const auto joint_set = attributes.find("JOINTS_" + std::to_string(n));
      const auto weight_set = attributes.find("WEIGHTS_" + std::to_string(n));
      if (joint_set == attributes.end() || weight_set == attributes.end()) break;
      const auto j = read_elements(document_, joint_set->second, {.type = TINYGLTF_TYPE_VEC4, .count = count});
      if (!j) return j.error();
      const auto w = read_elements(document_, weight_set->second, {.type = TINYGLTF_TYPE_VEC4, .count = count});
      if (!w) return w.error();
      sets.push_back({j->dense(), w->dense()});
    }
    std::map<std::uint32_t, double> shares;
    for (std::size_t v = 0; v < count; ++v) {
      shares.clear();
      for (const Set& set : sets) {
        for (std::size_t i = 4 * v; i < 4 * v + 4; ++i) {
          const float weight = set.weights[i];
          if (weight == 0.0F) continue;
          const float joint = set.joints[i];
          const bool fits =
              weight > 0.0F && weight < 1e9F && joint >= 0.0F && joint < static_cast<float>(joints.size());
          if (!fits) {
            ++unfit_;
            continue;
          }
          shares[joints[static_cast<std::size_t>(joint)]] += static_cast<double>(weight);
        }
      }
      if (shares.empty()) {
        unweighted_ = true;
        shares[joints.front()] = 1.0;
      }
      add_influences(shares);
    }
    return base::Done{};
  }

  /// Weights are rounded to the precision of the file, so that they are the same when they come back from one.
  void add_influences(const std::map<std::uint32_t, double>& shares) {
    double sum = 0;
    for (const auto& [joint, weight] : shares) sum += weight;
    const double scale = std::abs(sum - 1.0) < 2e-7 ? 1.0 : 1.0 / sum;
    for (const auto& [joint, weight] : shares) {
      const auto share = static_cast<float>(weight * scale);
      if (joint != k_still && share > 0.0F) result_.influences.push_back({joint, static_cast<double>(share)});
    }
    result_.first_influence.push_back(static_cast<std::uint32_t>(result_.influences.size()));
  }

  base::Status carry_part(std::size_t index) {
    const std::int32_t node = carrier_[index];
    const std::size_t count = meshes_.source.parts[index].vertex_count;
    const std::uint32_t joint = node == k_no_joint ? 0 : joint_with_bind(static_cast<std::size_t>(node), glm::dmat4(1));
    for (std::size_t v = 0; v < count; ++v) {
      if (node != k_no_joint) result_.influences.push_back({joint, 1.0});
      result_.first_influence.push_back(static_cast<std::uint32_t>(result_.influences.size()));
    }
    return base::Done{};
  }

  /// Parameters are called after their joints, so posable joints need names that differ.
  void finish_names() {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < result_.joints.size(); ++i) {
      rig::Joint& joint = result_.joints[i];
      if (joint.posable) names.push_back(joint.name.empty() ? "joint" + std::to_string(i) : joint.name);
    }
    make_unique(names);
    std::size_t next = 0;
    for (rig::Joint& joint : result_.joints) {
      if (joint.posable) joint.name = names[next++];
    }
  }

  GltfDocument& document_;
  const NodeTree& tree_;
  const GltfMeshes& meshes_;
  const std::vector<NodeExtras>& extras_;
  std::vector<NodeTransform> transforms_;
  std::vector<bool> moved_;  ///< not at the origin of its parent
  std::vector<bool> animated_;
  std::vector<bool> posable_;
  std::vector<std::int32_t> carrier_;  ///< one a part
  std::set<std::size_t> used_skins_;
  std::vector<std::size_t> order_;  ///< nodes that are joints
  std::vector<std::int32_t> joint_of_node_;
  std::vector<bool> has_bind_;
  std::map<std::uint32_t, std::vector<std::uint32_t>> more_binds_;
  std::vector<std::vector<std::uint32_t>> joints_of_skin_;
  bool unweighted_ = false;
  bool sheared_ = false;
  std::size_t unfit_ = 0;  ///< weights that were left out
  GltfSkeleton result_;
};

}  // namespace

base::Result<GltfSkeleton> read_skeleton(GltfDocument& document, const NodeTree& tree, const GltfMeshes& meshes,
                                         const std::vector<NodeExtras>& extras) {
  return SkeletonReader(document, tree, meshes, extras).read();
}

}  // namespace penpose::io
