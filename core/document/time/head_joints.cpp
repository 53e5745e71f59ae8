#include "core/document/time/head_joints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "core/base/math.h"
#include "core/base/text/letters.h"

namespace penpose::document {
namespace {

bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }
bool is_small(char c) { return c >= 'a' && c <= 'z'; }

/// The words of a name, in small letters: J_Bip_C_Head is j, bip, c, head. Digits and signs part words, and capitals
/// after small letters.
std::vector<std::string> letter_words(std::string_view name) {
  std::vector<std::string> words;
  bool open = false;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    if (!is_capital(c) && !is_small(c)) {
      open = false;
      continue;
    }
    if (!open || (is_capital(c) && is_small(name[i - 1]))) words.emplace_back();
    words.back() += base::lower(c);
    open = true;
  }
  return words;
}

bool has_word(const std::vector<std::string>& words, std::string_view word) {
  return std::any_of(words.begin(), words.end(), [&](const std::string& one) { return one == word; });
}

bool is_called_head(std::string_view name) {
  if (name == "頭") return true;
  const auto words = letter_words(name);
  constexpr std::array<const char*, 8> k_others{"end", "top", "nub", "tip", "target", "eye", "jaw", "hair"};
  const bool other =
      std::any_of(k_others.begin(), k_others.end(), [&](const char* one) { return has_word(words, one); });
  return has_word(words, "head") && !other;
}

bool is_called_neck(std::string_view name) { return name == "首" || has_word(letter_words(name), "neck"); }

/// How much of the vertices each joint carries with all below it, 0..1 of what they weigh.
std::vector<double> shares(const rig::Skeleton& skeleton, const std::vector<double>& weight_of_vertex) {
  const auto joints = skeleton.joints();
  std::vector<double> shares(joints.size(), 0.0);
  double all = 0;
  for (std::uint32_t v = 0; v < skeleton.vertex_count() && v < weight_of_vertex.size(); ++v) {
    if (weight_of_vertex[v] == 0) continue;
    all += weight_of_vertex[v];
    for (const rig::Influence& influence : skeleton.influences_of(v)) {
      shares[influence.joint] += influence.weight * weight_of_vertex[v];
    }
  }
  for (std::size_t j = joints.size(); j-- > 0;) {
    if (joints[j].parent >= 0) shares[static_cast<std::size_t>(joints[j].parent)] += shares[j];
  }
  for (double& share : shares) share = all > 0 ? share / all : 0;
  return shares;
}

/// How many shapes move each vertex.
std::vector<double> moved_by_shapes(const Model& model) {
  std::vector<double> weights(model.mesh->vertex_count(), 0.0);
  if (!model.shapes) return weights;
  for (const rig::BlendShape& shape : model.shapes->shapes()) {
    for (const std::uint32_t v : shape.vertices) weights[v] += 1;
  }
  return weights;
}

std::optional<std::uint32_t> head_by_name(const rig::Skeleton& skeleton, const std::vector<double>& of_shapes,
                                          bool any) {
  constexpr double k_least = 0.5;
  std::optional<std::uint32_t> best;
  for (std::uint32_t j = 0; j < skeleton.joints().size(); ++j) {
    if (!is_called_head(skeleton.joints()[j].name) || (any && of_shapes[j] < k_least)) continue;
    if (!best || of_shapes[j] > of_shapes[*best]) best = j;
  }
  return best;
}

std::optional<std::uint32_t> head_by_weight(const rig::Skeleton& skeleton, const std::vector<double>& of_shapes,
                                            const std::vector<double>& of_all) {
  constexpr double k_most = 0.9;
  std::optional<std::uint32_t> found;
  // Parents come before their children.
  for (std::uint32_t j = 0; j < skeleton.joints().size(); ++j) {
    const std::int32_t parent = skeleton.joints()[j].parent;
    const bool below = !found ? parent < 0 : parent == static_cast<std::int32_t>(*found);
    if (below && of_shapes[j] >= k_most) found = j;
  }
  if (!found || of_all[*found] > k_most) return std::nullopt;
  return found;
}

/// The part of a rotation that goes `share` of its way.
glm::dquat part_of(glm::dquat q, double share) {
  if (q.w < 0) q = -q;
  const double size = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z);
  if (!(size > 0)) return {1, 0, 0, 0};
  const double half = share * base::atan2(size, q.w);
  const double k = base::sin(half) / size;
  return {base::cos(half), k * q.x, k * q.y, k * q.z};
}

glm::dquat unit(const glm::dquat& q) {
  const double size = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return size > 0 ? glm::dquat(q.w / size, q.x / size, q.y / size, q.z / size) : glm::dquat(1, 0, 0, 0);
}

/// Rotation of a joint in the model, where each joint of the skeleton is turned so from its parent.
template <typename Rotation>
glm::dquat world_rotation(const rig::Skeleton& skeleton, std::int32_t joint, const Rotation& rotation) {
  glm::dquat world(1, 0, 0, 0);
  while (joint >= 0) {
    world = unit(rotation(static_cast<std::size_t>(joint))) * world;
    joint = skeleton.joints()[static_cast<std::size_t>(joint)].parent;
  }
  return world;
}

glm::dquat rest_world(const rig::Skeleton& skeleton, std::int32_t joint) {
  return world_rotation(skeleton, joint, [&](std::size_t j) { return skeleton.joints()[j].rest_rotation; });
}

double as_float(double value) { return static_cast<double>(static_cast<float>(value)); }

}  // namespace

std::optional<HeadJoints> head_joints(const Model& model) {
  if (!model.skeleton) return std::nullopt;
  const auto joints = model.skeleton->joints();
  const auto weights = moved_by_shapes(model);
  const auto of_shapes = shares(*model.skeleton, weights);
  const bool any = std::any_of(weights.begin(), weights.end(), [](double weight) { return weight > 0; });
  const auto in_range = [&](std::optional<std::uint32_t> joint) {
    return joint && *joint < joints.size() ? joint : std::nullopt;
  };
  auto head = in_range(model.humanoid.joint(HumanBone::head));
  if (!head) head = head_by_name(*model.skeleton, of_shapes, any);
  if (!head && any) {
    const auto of_all = shares(*model.skeleton, std::vector<double>(model.mesh->vertex_count(), 1.0));
    head = head_by_weight(*model.skeleton, of_shapes, of_all);
  }
  if (!head || joints[*head].parent < 0) return std::nullopt;
  HeadJoints result{*head, {}};
  const auto neck = in_range(model.humanoid.joint(HumanBone::neck));
  const auto is_neck = [&](std::int32_t joint) {
    return (neck && joint == static_cast<std::int32_t>(*neck)) ||
           is_called_neck(joints[static_cast<std::size_t>(joint)].name);
  };
  for (std::int32_t j = joints[*head].parent; j >= 0 && is_neck(j); j = joints[static_cast<std::size_t>(j)].parent) {
    result.necks.insert(result.necks.begin(), static_cast<std::uint32_t>(j));
  }
  return result;
}

Model with_head_turns(Model model, std::size_t animation, const HeadJoints& joints, std::span<const double> times_s,
                      std::span<const Placement> placements) {
  constexpr double k_of_necks = 0.5;
  const rig::Skeleton& skeleton = *model.skeleton;
  std::vector<std::uint32_t> chain = joints.necks;
  chain.push_back(joints.head);
  std::vector<double> shares(chain.size(), 1.0);
  for (std::size_t k = 0; k < joints.necks.size(); ++k) {
    shares[k] = k_of_necks * static_cast<double>(k + 1) / static_cast<double>(joints.necks.size());
  }
  auto& channels = model.animations[animation].channels;
  std::vector<Channel> made;
  for (const std::uint32_t j : chain) {
    std::erase_if(channels, [&](const Channel& c) { return c.target == ChannelTarget::rotation && c.joint == j; });
    made.push_back({ChannelTarget::rotation, j, Interpolation::linear, {}, {}});
  }
  for (std::size_t f = 0; f < times_s.size() && f < placements.size(); ++f) {
    const double time = as_float(times_s[f] - times_s[0]);
    if (!made[0].times_s.empty() && !(time > made[0].times_s.back())) continue;
    glm::dquat before(1, 0, 0, 0);  // how far the parent has turned
    for (std::size_t k = 0; k < chain.size(); ++k) {
      const rig::Joint& joint = skeleton.joints()[chain[k]];
      const glm::dquat turned = part_of(unit(placements[f].rotation), shares[k]);
      const glm::dquat parent = rest_world(skeleton, joint.parent);
      glm::dquat local = unit(glm::conjugate(before * parent) * turned * parent * unit(joint.rest_rotation));
      auto& values = made[k].values;
      if (values.size() >= 4) {
        // Neighbouring keys lie on the same side, so that a viewer that mixes numbers does not go round the long way.
        const double* last = &values[values.size() - 4];
        if (last[0] * local.x + last[1] * local.y + last[2] * local.z + last[3] * local.w < 0) local = -local;
      }
      for (const double part : {local.x, local.y, local.z, local.w}) values.push_back(as_float(part));
      made[k].times_s.push_back(time);
      before = turned;
    }
  }
  channels.insert(channels.end(), made.begin(), made.end());
  return model;
}

glm::dquat turn_from_rest(const Model& model, std::uint32_t joint, std::span<const JointTransform> joints) {
  const auto at = static_cast<std::int32_t>(joint);
  const auto now = world_rotation(*model.skeleton, at, [&](std::size_t j) { return joints[j].rotation; });
  return now * glm::conjugate(rest_world(*model.skeleton, at));
}

}  // namespace penpose::document
