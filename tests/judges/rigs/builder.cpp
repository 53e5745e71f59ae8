#include "tests/judges/rigs/builder.h"

#include <algorithm>
#include <cmath>

#include "core/base/math.h"
#include "core/geometry/rotation.h"
#include "core/rig/character_rig.h"
#include "tests/judges/rigs/control_words.h"
#include "tests/judges/rigs/sculpt.h"

namespace penpose::judges {
namespace {

rig::BlendShape baked(std::string name, const Field& field) {
  double most = 0;
  for (const ModelVector& d : field) most = std::max(most, geometry::length(d));
  rig::BlendShape shape;
  shape.parameter.name = std::move(name);
  for (std::uint32_t v = 0; v < field.size(); ++v) {
    // Files leave out what nobody sees.
    if (geometry::length(field[v]) <= 1e-3 * most) continue;
    shape.vertices.push_back(v);
    shape.deltas.emplace_back(field[v]);
  }
  return shape;
}

}  // namespace

FaceBuilder::FaceBuilder(std::string name, std::string kind, Group group, const Parts& parts) : parts_(parts) {
  rig_.name = std::move(name);
  rig_.kind = std::move(kind);
  rig_.group = group;
  rig_.lines = parts.lines;
  influences_.resize(parts.rest().size());
}

std::optional<std::string> FaceBuilder::add_shape(std::string name, Recipe recipe, std::optional<Means> means) {
  const auto strongest = [&] {
    double most = 0;
    for (const auto& [muscle, amount] : recipe) most = std::max(most, std::abs(amount));
    return most;
  };
  if (!means) {
    means.emplace();
    for (const auto& [muscle, amount] : recipe) {
      if (std::abs(amount) >= 0.5 * strongest()) means->push_back(muscle);
    }
  }
  if (maker_ && !maker_(name, recipe, *means)) return {};
  Field field(parts_.rest().size(), ModelVector{0});
  for (const auto& [muscle, amount] : recipe) add_to(field, amount, parts_.field(muscle));
  shapes_.push_back(baked(name, field));
  acts_.push_back({{{name, 1 / strongest()}}, std::move(*means)});
  return name;
}

void FaceBuilder::shape(std::string name, const Recipe& recipe, std::optional<Means> means) {
  add_shape(std::move(name), recipe, std::move(means));
}

void FaceBuilder::sides(const std::string& name, const Recipe& recipe) { sides(name, "_L", "_R", "", recipe); }

void FaceBuilder::sides(const std::string& before, const std::string& left, const std::string& right,
                        const std::string& behind, const Recipe& recipe) {
  for (const bool is_left : {true, false}) {
    Recipe own;
    for (const auto& [muscle, amount] : recipe)
      own.emplace_back(muscle.back() == '_' ? muscle + (is_left ? "L" : "R") : muscle, amount);
    shape(before + (is_left ? left : right) + behind, own);
  }
}

void FaceBuilder::emote(std::string name, const Recipe& recipe) {
  if (const auto made = add_shape(std::move(name), recipe, Means{})) pose("emote_" + *made, {{*made, 0.8}});
}

std::size_t FaceBuilder::joint(std::string name, std::int32_t parent, const ModelPoint& at, double degrees) {
  return this->joint(std::move(name), parent, at, degrees, {1, 0, 0, 0});
}

std::size_t FaceBuilder::joint(std::string name, std::int32_t parent, const ModelPoint& at, double degrees,
                               const glm::dquat& frame) {
  const glm::dquat to_own = glm::conjugate(frame);
  rig::Joint joint;
  joint.name = std::move(name);
  joint.parent = parent;
  joint.translation = at;
  joint.rest_rotation = frame;
  if (parent >= 0) {
    const auto above = static_cast<std::size_t>(parent);
    joint.translation = glm::conjugate(joint_frames_[above]) * (at - joint_places_[above]);
    joint.rest_rotation = glm::conjugate(joint_frames_[above]) * frame;
  }
  joint.inverse_bind = geometry::compose(-(to_own * at), to_own, {1, 1, 1});
  joint.maximum = glm::dvec3(degrees * 3.14159265358979323846 / 180);
  joint.minimum = -joint.maximum;
  joints_.push_back(std::move(joint));
  joint_places_.push_back(at);
  joint_frames_.push_back(frame);
  return joints_.size() - 1;
}

void FaceBuilder::carry(std::size_t joint, std::span<const double> share) {
  for (std::size_t v = 0; v < share.size(); ++v) {
    if (share[v] < 1e-3) continue;
    for (rig::Influence& other : influences_[v]) other.weight *= 1 - share[v];
    std::erase_if(influences_[v], [](const rig::Influence& i) { return i.weight < 1e-6; });
    influences_[v].push_back({static_cast<std::uint32_t>(joint), share[v]});
  }
}

void FaceBuilder::turn_means(std::string parameter, double at_most, Means muscles) {
  turns_mean({{std::move(parameter), at_most}}, std::move(muscles));
}

void FaceBuilder::turns_mean(Values at_most, Means muscles) {
  acts_.push_back({std::move(at_most), std::move(muscles)});
}

Values FaceBuilder::turned_about(std::size_t joint, const ModelVector& axis, double angle) const {
  const ModelVector own = glm::conjugate(joint_frames_[joint]) * geometry::normalized(axis);
  const glm::dquat turn(base::cos(0.5 * angle), own * base::sin(0.5 * angle));
  const glm::dvec3 angles = geometry::xyz_from_quaternion(turn);
  const std::string& name = joints_[joint].name;
  Values values;
  for (const auto& [end, value] : {std::pair{".rx", angles.x}, {".ry", angles.y}, {".rz", angles.z}}) {
    if (std::abs(value) > 1e-6) values.emplace_back(name + end, value);
  }
  return values;
}

void FaceBuilder::pose(std::string name, Values values) { rig_.poses.push_back({std::move(name), std::move(values)}); }

void FaceBuilder::add_expressions() {
  std::vector<KnownPose> known;
  std::vector<Expression> asked(expressions().begin(), expressions().end());
  asked.insert(asked.end(), more_.begin(), more_.end());
  for (const Expression& expression : asked) {
    KnownPose pose{expression.name, {}};
    std::vector<std::string> all;
    for (const auto& [muscle, amount] : expression.muscles) all.push_back(muscle);
    std::vector<std::string> made;
    for (const auto& [muscle, amount] : expression.muscles) {
      if (has(made, muscle)) continue;
      const Act* best = nullptr;
      for (const Act& act : acts_) {
        const bool fits = has(act.means, muscle) && std::all_of(act.means.begin(), act.means.end(), [&](const auto& m) {
                            return has(all, m) && !has(made, m);
                          });
        if (fits && (!best || act.means.size() < best->means.size())) best = &act;
      }
      if (!best) break;
      for (const auto& [parameter, at_most] : best->at_most) {
        const double value = amount * at_most;
        const auto same = std::find_if(pose.values.begin(), pose.values.end(),
                                       [&called = parameter](const auto& v) { return v.first == called; });
        if (same != pose.values.end()) {
          same->second += value;
        } else {
          pose.values.emplace_back(parameter, at_most < 0 ? value : std::min(value, 1.0));
        }
      }
      made.insert(made.end(), best->means.begin(), best->means.end());
    }
    if (made.size() == all.size()) known.push_back(std::move(pose));
  }
  known.insert(known.end(), rig_.poses.begin(), rig_.poses.end());
  rig_.poses = std::move(known);
}

Rig FaceBuilder::build() {
  add_expressions();
  for (const Act& act : acts_) {
    for (const auto& [parameter, at_most] : act.at_most) {
      const std::string control = control_of(parameter);
      auto known = std::find_if(rig_.meanings.begin(), rig_.meanings.end(),
                                [&](const Meaning& m) { return m.control == control; });
      if (known == rig_.meanings.end()) known = rig_.meanings.insert(known, {control, {}});
      for (const std::string& muscle : act.means) {
        if (!has(known->means, muscle)) known->means.push_back(muscle);
      }
    }
  }
  std::shared_ptr<const rig::BlendShapes> shapes;
  if (!shapes_.empty()) shapes = rig::BlendShapes::make(std::move(shapes_), parts_.rest().size()).value();
  std::shared_ptr<const rig::Skeleton> skeleton;
  if (!joints_.empty()) {
    std::vector<std::uint32_t> first{0};
    std::vector<rig::Influence> influences;
    for (const auto& of_vertex : influences_) {
      influences.insert(influences.end(), of_vertex.begin(), of_vertex.end());
      first.push_back(static_cast<std::uint32_t>(influences.size()));
    }
    skeleton = rig::Skeleton::make(std::move(joints_), std::move(first), std::move(influences)).value();
  }
  rig_.model = document::make_model(parts_.mesh, std::move(shapes), std::move(skeleton)).value();
  return std::move(rig_);
}

}  // namespace penpose::judges
