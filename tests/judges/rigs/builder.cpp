#include "tests/judges/rigs/builder.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/rotation.h"
#include "core/rig/character_rig.h"
#include "tests/judges/rigs/control_words.h"
#include "tests/judges/rigs/expressions.h"
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

void FaceBuilder::shape(std::string name, const Recipe& recipe, std::optional<Means> means) {
  Field field(parts_.rest().size(), ModelVector{0});
  for (const auto& [muscle, amount] : recipe) add_to(field, amount, parts_.field(muscle));
  double most = 0;
  for (const auto& [muscle, amount] : recipe) most = std::max(most, std::abs(amount));
  if (!means) {
    means.emplace();
    for (const auto& [muscle, amount] : recipe) {
      if (std::abs(amount) >= 0.5 * most) means->push_back(muscle);
    }
  }
  shapes_.push_back(baked(name, field));
  acts_.push_back({std::move(name), std::move(*means), 1 / most});
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
  pose("emote_" + name, {{name, 0.8}});
  shape(std::move(name), recipe, Means{});
}

std::size_t FaceBuilder::joint(std::string name, std::int32_t parent, const ModelPoint& at, double degrees) {
  rig::Joint joint;
  joint.name = std::move(name);
  joint.parent = parent;
  joint.translation = parent < 0 ? at : at - joint_places_[static_cast<std::size_t>(parent)];
  joint.inverse_bind = geometry::compose(-at, {1, 0, 0, 0}, {1, 1, 1});
  joint.maximum = glm::dvec3(degrees * 3.14159265358979323846 / 180);
  joint.minimum = -joint.maximum;
  joints_.push_back(std::move(joint));
  joint_places_.push_back(at);
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
  acts_.push_back({std::move(parameter), std::move(muscles), at_most});
}

void FaceBuilder::pose(std::string name, std::vector<std::pair<std::string, double>> values) {
  rig_.poses.push_back({std::move(name), std::move(values)});
}

void FaceBuilder::add_expressions() {
  std::vector<KnownPose> known;
  for (const Expression& expression : expressions()) {
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
      const double value = amount * best->at_one;
      pose.values.emplace_back(best->parameter, best->at_one < 0 ? value : std::min(value, 1.0));
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
    const std::string control = control_of(act.parameter);
    const auto known = std::find_if(rig_.meanings.begin(), rig_.meanings.end(),
                                    [&](const Meaning& m) { return m.control == control; });
    if (known == rig_.meanings.end()) {
      rig_.meanings.push_back({control, act.means});
    } else {
      known->means.insert(known->means.end(), act.means.begin(), act.means.end());
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
