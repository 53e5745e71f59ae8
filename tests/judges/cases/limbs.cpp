#include "tests/judges/cases/limbs.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/base/math.h"
#include "core/geometry/rotation.h"
#include "tests/judges/cases/picture.h"
#include "tests/judges/hands/hand.h"

namespace penpose::judges {
namespace {

std::span<const double> joint_values(const document::Model& model, const rig::Pose& pose) {
  return std::span(pose).subspan(model.rig->first_parameter(model.rig->layers().size()));
}

/// From a joint's own space to the world.
std::vector<glm::dmat4> frames(const document::Model& model, const rig::Pose& pose) {
  std::vector<glm::dmat4> matrices(model.skeleton->joints().size());
  model.skeleton->joint_matrices(joint_values(model, pose), matrices);
  for (std::size_t j = 0; j < matrices.size(); ++j)
    matrices[j] = matrices[j] * glm::inverse(model.skeleton->joints()[j].inverse_bind);
  return matrices;
}

glm::dquat rotation_of(const glm::dmat4& frame) {
  glm::dmat3 axes(frame);
  for (int k = 0; k < 3; ++k) axes[k] = geometry::normalized(axes[k]);
  return glm::normalize(glm::quat_cast(axes));
}

glm::dquat about(const geometry::ModelVector& degrees) {
  const double angle = base::radians(geometry::length(degrees));
  const geometry::ModelVector axis = geometry::normalized(degrees) * base::sin(angle / 2);
  return {base::cos(angle / 2), axis.x, axis.y, axis.z};
}

/// How much of a vertex these joints carry.
double carried(const rig::Skeleton& skeleton, std::uint32_t vertex, std::span<const std::size_t> joints) {
  double sum = 0;
  for (const rig::Influence& one : skeleton.influences_of(vertex)) {
    if (std::find(joints.begin(), joints.end(), one.joint) != joints.end()) sum += one.weight;
  }
  return sum;
}

/// Places along the bones of a chain, to the end of what its last joint carries.
std::vector<ModelPoint> bones_of(const document::Model& model, const std::vector<ModelPoint>& rest,
                                 const std::vector<std::size_t>& chain) {
  const auto matrices = frames(model, rig::rest_pose(*model.rig));
  std::vector<ModelPoint> bones;
  for (const std::size_t j : chain) bones.emplace_back(matrices[j][3]);
  ModelPoint middle{0};
  double count = 0;
  for (std::uint32_t v = 0; v < rest.size(); ++v) {
    if (carried(*model.skeleton, v, std::span(&chain.back(), 1)) <= 0.5) continue;
    middle += rest[v];
    ++count;
  }
  if (count > 0) bones.push_back(bones.back() + (middle / count - bones.back()) * 1.9);
  return bones;
}

/// Vertices of the side that is seen, next to the bones.
std::vector<std::uint32_t> seen_along(const document::Model& model, const std::vector<ModelPoint>& rest,
                                      const Move& move, const Picture& picture, double height) {
  constexpr int k_places = 16;
  const auto bones = bones_of(model, rest, move.chain);
  std::vector<double> along{0};
  for (std::size_t i = 1; i < bones.size(); ++i)
    along.push_back(along.back() + geometry::distance(bones[i - 1], bones[i]));
  const geometry::ModelVector back{base::sin(base::radians(move.yaw_degrees)), 0,
                                   base::cos(base::radians(move.yaw_degrees))};
  std::vector<std::uint32_t> found;
  for (int k = 0; k < k_places; ++k) {
    const double length = along.back() * k / (k_places - 1);
    std::size_t i = 1;
    while (i + 1 < bones.size() && along[i] < length) ++i;
    const double t = (length - along[i - 1]) / (along[i] - along[i - 1]);
    const ModelPoint place = bones[i - 1] + (bones[i] - bones[i - 1]) * t;
    double least = 1e300;
    std::uint32_t best = 0;
    for (std::uint32_t v = 0; v < rest.size(); ++v) {
      if (carried(*model.skeleton, v, move.chain) <= 0.5) continue;
      const double aside = geometry::distance(picture.flat(rest[v]), picture.flat(place)) * height / Picture::k_face_px;
      const double distance = aside - 0.3 * glm::dot(rest[v] - place, back);
      if (distance >= least) continue;
      least = distance;
      best = v;
    }
    if (found.empty() || found.back() != best) found.push_back(best);
  }
  return found;
}

}  // namespace

rig::Pose turned_pose(const document::Model& model, std::span<const Move::Turn> turns) {
  rig::Pose pose = rig::rest_pose(*model.rig);
  const std::size_t first = model.rig->first_parameter(model.rig->layers().size());
  for (const Move::Turn& turn : turns) {
    const glm::dquat frame = rotation_of(frames(model, pose)[turn.joint]);
    for (std::size_t k = 0; k < model.skeleton->parameters().size(); k += 3) {
      if (model.skeleton->joint_of(k) != turn.joint) continue;
      const glm::dvec3 before{pose[first + k], pose[first + k + 1], pose[first + k + 2]};
      const glm::dquat own = glm::conjugate(frame) * about(turn.degrees) * frame;
      const glm::dvec3 after = geometry::xyz_from_quaternion(geometry::quaternion_from_xyz(before) * own);
      for (int axis = 0; axis < 3; ++axis) pose[first + k + static_cast<std::size_t>(axis)] = after[axis];
    }
  }
  return pose;
}

double height_of(const document::Model& model) {
  const geometry::Box box = document::rest_world_box(model);
  const geometry::ModelVector sides = box.maximum - box.minimum;
  return std::max({sides.x, sides.y, sides.z});
}

std::vector<Limb> limbs(const Rig& rig, Extent extent) {
  const auto rest = posed(rig.model, rig::rest_pose(*rig.model.rig));
  const double height = height_of(rig.model);
  std::vector<Limb> all;
  std::size_t number = 0;
  for (const Move& move : rig.moves) {
    const Picture picture(move.yaw_degrees, height);
    const auto vertices = seen_along(rig.model, rest, move, picture, height);
    const rig::Pose truth = turned_pose(rig.model, move.turns);
    const auto places = posed(rig.model, truth);
    std::vector<const char*> hands{"exact", "tremor_2", "uneven", "backwards"};
    ++number;
    if (extent == Extent::brief) hands = {hands[number % hands.size()], hands[(number + 1) % hands.size()]};
    for (const char* called : hands) {
      Limb limb;
      limb.asked.name = move.name + "/" + called;
      limb.asked.view_yaw_degrees = move.yaw_degrees;
      limb.hand = called;
      limb.truth = truth;
      const auto drawn =
          drawn_by(hand_named(called), picture.flat(places, vertices), seed_of(rig.name, limb.asked.name));
      limb.asked.references.push_back({move.name, vertices, picture.in_space(drawn, places, vertices), {}});
      all.push_back(std::move(limb));
    }
  }
  return all;
}

}  // namespace penpose::judges
