#include "core/intent/model/whole_model.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/geometry/space.h"
#include "core/intent/model/control_effects.h"
#include "core/intent/model/mirror_pairs.h"
#include "core/intent/model/places_moved.h"
#include "core/rig/character_rig.h"

namespace penpose::intent {
namespace {

using geometry::ModelPoint;
using geometry::ModelVector;

double median_of_positive(std::vector<double> values) {
  std::erase_if(values, [](double v) { return !(v > 0.0); });
  if (values.empty()) return 1.0;
  std::stable_sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// See WholeModel::joint_extents.
std::vector<double> extents_of(const rig::Skeleton& skeleton, std::span<const ModelPoint> rest) {
  std::vector<geometry::Box> boxes(skeleton.joints().size());
  for (std::size_t v = 0; v < rest.size(); ++v) {
    const auto influences = skeleton.influences_of(static_cast<std::uint32_t>(v));
    const auto most = std::max_element(influences.begin(), influences.end(),
                                       [](const auto& a, const auto& b) { return a.weight < b.weight; });
    if (most != influences.end() && most->weight > 0.0) boxes[most->joint].add(rest[v]);
  }
  std::vector<double> out;
  for (const geometry::Box& box : boxes) out.push_back(box.empty() ? 0.0 : box.diagonal());
  return out;
}

/// The mean way of what moves, each vertex weighted by its own way.
double stride_of(std::span<const ModelPoint> rest, std::span<const ModelPoint> moved) {
  double ways = 0, squares = 0;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    const double way = geometry::distance(rest[i], moved[i]);
    ways += way;
    squares += way * way;
  }
  return ways > 0.0 ? squares / ways : 0.0;
}

/// Which vertices shapes move, and how far they press them into each other.
Contacts contacts_of(const rig::Rig& rig, std::span<const ModelPoint> rest, const std::vector<bool>& moved,
                     const std::vector<bool>& shapes) {
  const auto* character = dynamic_cast<const rig::CharacterRig*>(&rig);
  Contacts contacts = character != nullptr ? Contacts(character->mesh(), rest, moved) : Contacts{};
  const auto bound = rig.bind(contacts.vertices());
  std::vector<ModelPoint> here(contacts.vertices().size()), there(here.size());
  rig::Pose pose = rig::rest_pose(rig);
  bound->evaluate(pose, here);
  for (std::size_t p = 0; p < pose.size(); ++p) {
    const rig::Parameter& parameter = rig.parameters()[p];
    if (!shapes[p] || !bound->moves(p)) {
      contacts.add(here, {}, 0);
      continue;
    }
    const double range = parameter.maximum - parameter.minimum;
    const bool up = parameter.maximum > parameter.rest;
    const double end = up ? parameter.maximum : parameter.minimum;
    pose[p] = end;
    bound->evaluate(pose, there);
    pose[p] = parameter.rest;
    contacts.add(here, there, range / (end - parameter.rest));
  }
  return contacts;
}

/// See WholeModel::by_piece.
std::vector<std::vector<WholeModel::OfPiece>> turns_by_piece(const ControlFields& fields,
                                                             std::span<const std::uint32_t> pieces) {
  struct Sums {
    double count = 0, square = 0;
    ModelVector way{0};
  };
  std::vector<std::vector<WholeModel::OfPiece>> out(fields.control_count());
  if (pieces.empty()) return out;
  const auto samples = fields.samples();
  std::vector<double> sizes(*std::max_element(pieces.begin(), pieces.end()) + std::size_t{1}, 0.0);
  for (const std::uint32_t v : samples) sizes[pieces[v]] += 1.0;
  for (std::size_t p = 0; p < out.size(); ++p) {
    if (!(fields.square(p) > 0.0)) continue;
    std::map<std::uint32_t, Sums> sums;
    const auto field = fields.field(p);
    for (std::size_t i = 0; i < field.samples.size(); ++i) {
      Sums& of = sums[pieces[samples[field.samples[i]]]];
      of.square += square_of(field.ways[i]);
      of.way += field.ways[i];
    }
    for (const auto& [piece, of] : sums) {
      const ModelVector mean = of.way / sizes[piece];
      const double variance = of.square / sizes[piece] - square_of(mean);
      if (variance > 0.0) out[p].push_back({piece, std::sqrt(variance)});
    }
  }
  return out;
}

/// A shape moves a sample if its squared way is more than this share of the largest one.
constexpr double k_moved_square = 0.01;

/// Computes WholeModel::bears.
std::vector<double> shares_borne(const ControlFields& fields, const std::vector<bool>& shapes,
                                 std::span<const std::size_t> joint) {
  std::vector<double> done(fields.places().size(), 0.0);  // by shapes, at each sample
  double all = 0;
  for (std::size_t p = 0; p < shapes.size(); ++p) {
    if (!shapes[p] || !(fields.square(p) > 0.0)) continue;
    const ControlField field = fields.field(p);
    double most = 0;
    for (const ModelVector& way : field.ways) most = std::max(most, square_of(way));
    const auto moved = std::count_if(field.ways.begin(), field.ways.end(),
                                     [&](const ModelVector& way) { return square_of(way) > k_moved_square * most; });
    // A shape of the whole body says little of a part of it.
    const double still = 1.0 - static_cast<double>(moved) / static_cast<double>(done.size());
    for (std::size_t i = 0; i < field.samples.size(); ++i)
      done[field.samples[i]] += still * still * square_of(field.ways[i]) / fields.square(p);
    all += still * still;
  }
  std::vector<double> borne(shapes.size(), 0.0);
  for (std::size_t p = 0; p < borne.size() && all > 0.0; ++p) {
    if (joint[p] == k_no_partner) continue;
    for (const std::uint32_t sample : fields.field(p).samples) borne[p] += done[sample];
    borne[p] /= all;
  }
  return borne;
}

}  // namespace

WholeModel measure_whole_model(const rig::Rig& rig) {
  const auto parameters = rig.parameters();
  const std::size_t d = parameters.size();
  WholeModel whole;
  whole.movement.assign(d, 0.0);
  whole.stride.assign(d, 0.0);
  whole.group.resize(d);
  whole.joint.assign(d, k_no_partner);
  for (std::size_t p = 0; p < d; ++p) whole.group[p] = p;
  if (const auto* character = dynamic_cast<const rig::CharacterRig*>(&rig); character && character->skeleton()) {
    whole.body = std::make_shared<joints::Body>(*character->skeleton());
    const std::size_t first = character->first_parameter(character->layers().size());
    for (std::size_t p = first; p < d; ++p) {
      whole.group[p] = first + (p - first) / 3 * 3;
      whole.joint[p] = character->skeleton()->joint_of(p - first);
    }
  }

  ControlEffects effects(rig);
  const std::span<const ModelPoint> rest = effects.rest();
  geometry::Box box;
  for (const ModelPoint& p : rest) box.add(p);
  whole.size = box.empty() ? 0.0 : box.diagonal();

  if (const auto* character = dynamic_cast<const rig::CharacterRig*>(&rig); whole.body)
    whole.joint_extents = extents_of(*character->skeleton(), rest);

  if (const auto* character = dynamic_cast<const rig::CharacterRig*>(&rig)) {
    const auto components = character->mesh().components();
    whole.pieces.assign(components.begin(), components.end());
  }
  ControlFields fields(rest);
  std::vector<bool> moved_by_shapes(rest.size());
  std::vector<ControlMoments> moments(d);
  for (std::size_t p = 0; p < d; ++p) {
    const rig::Parameter& parameter = parameters[p];
    const double up = parameter.maximum - parameter.rest;
    const double down = parameter.rest - parameter.minimum;
    // A turn of a right angle would say more of the arm's length than of the turn: joints are measured by a small one.
    const double step = whole.joint[p] != k_no_partner ? std::min(0.25, std::max(up, down)) : std::max(up, down);
    if (!(step > 0.0) || !std::isfinite(step)) {
      fields.add({}, {}, {}, 0);
      continue;
    }
    const double sign = up >= down ? 1.0 : -1.0;
    const bool turns = whole.joint[p] != k_no_partner;
    const ControlEffect effect = effects.of(p, parameter.rest + (up >= down ? step : -step));
    fields.add(effect.vertices, effect.rest, effect.moved,
               sign * (turns ? 1.0 : parameter.maximum - parameter.minimum) / step);
    for (std::size_t k = 0; k < effect.vertices.size() && !turns; ++k) {
      if (effect.moved[k] != effect.rest[k]) moved_by_shapes[effect.vertices[k]] = true;
    }
    moments[p] = moments_of(effect.rest, effect.moved);
    whole.movement[p] = moments[p].way * (parameter.maximum - parameter.minimum) / step;
    if (!std::isfinite(whole.movement[p])) whole.movement[p] = 0;
    whole.stride[p] = stride_of(effect.rest, effect.moved) * (parameter.maximum - parameter.minimum) / step;
    if (!std::isfinite(whole.stride[p])) whole.stride[p] = 0;
  }
  const double median = median_of_positive(whole.movement);
  for (double& movement : whole.movement) movement /= median;
  std::vector<bool> shapes(d);
  for (std::size_t p = 0; p < d; ++p) shapes[p] = whole.joint[p] == k_no_partner && whole.movement[p] > 0.0;
  whole.composites = composites_of(fields, shapes);
  whole.contacts = std::make_shared<const Contacts>(contacts_of(rig, rest, moved_by_shapes, shapes));
  whole.by_piece = turns_by_piece(fields, whole.pieces);
  whole.places = places_moved(fields, shapes);
  whole.bears = shares_borne(fields, shapes, whole.joint);
  whole.fields = std::make_shared<const ControlFields>(std::move(fields));
  whole.partner = mirror_pairs(moments, box.empty() ? ModelPoint{0} : box.center(), whole.size);
  whole.rest = std::make_shared<const std::vector<ModelPoint>>(rest.begin(), rest.end());
  return whole;
}

}  // namespace penpose::intent
