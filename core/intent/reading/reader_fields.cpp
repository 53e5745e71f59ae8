#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>

#include "core/algebra/vectors.h"
#include "core/base/math.h"
#include "core/intent/reading/reader.h"

// Of lines on faces: what controls do to the whole model beside what was drawn, and what that costs.

namespace penpose::intent {

using inference::Term;

namespace {

/// Where nothing was moved at all: more than any ratio that counts.
constexpr double k_no_share = 1e6;
/// A control moves a group of curves that it moves by this share of what anything moves it.
constexpr double k_tells = 0.05;

}  // namespace

std::vector<ModelPoint> Reader::at_rest(std::span<const posing::CurvePoint> reference) const {
  std::vector<ModelPoint> out;
  for (const posing::CurvePoint& point : reference) {
    ModelPoint at{0};
    for (std::size_t k = 0; k < 3; ++k) at += (*whole_.rest)[point.vertex[k]] * point.weight[k];
    out.push_back(at);
  }
  return out;
}

bool Reader::spans(std::span<const posing::CurvePoint> reference, std::span<const std::size_t> chain) const {
  if (chain.empty()) return false;
  // A brow does not speak for the head that carries what moves faces.
  if (any_span_) return !std::all_of(chain.begin(), chain.end(), [&](std::size_t joint) { return bears_face(joint); });
  double largest = 0;
  for (const std::size_t joint : chain) largest = std::max(largest, whole_.joint_extents[joint]);
  geometry::Box box;
  for (const ModelPoint& at : at_rest(reference)) box.add(at);
  return box.diagonal() >= weights_.spans * largest;
}

void Reader::group_curves() {
  const std::size_t count = told_count();
  std::vector<std::size_t> group(count);
  const auto points = [&](std::size_t c) { return std::span(start_).subspan(blocks_[c].first, blocks_[c].count); };
  const auto extent = [&](std::size_t c) {
    geometry::Box box;
    for (const ModelPoint& p : points(c)) box.add(p);
    return box.diagonal();
  };
  for (std::size_t c = 0; c < count; ++c) {
    group[c] = c;
    for (std::size_t k = 0; k < c; ++k) {
      const double far = weights_.together * std::min(extent(c), extent(k));
      const bool meets = std::any_of(points(c).begin(), points(c).end(), [&](const ModelPoint& p) {
        return std::any_of(points(k).begin(), points(k).end(),
                           [&](const ModelPoint& q) { return square_of(p - q) < far * far; });
      });
      if (!meets) continue;
      std::replace(group.begin(), group.begin() + static_cast<std::ptrdiff_t>(c) + 1, std::size_t{group[c]},
                   std::size_t{group[k]});
    }
  }
  std::vector<std::size_t> number(count, k_no_partner);
  for (std::size_t c = 0; c < count; ++c) {
    if (number[group[c]] == k_no_partner) number[group[c]] = doubt_.add_group(weights_.reach);
    doubt_.add_curve(number[group[c]]);
  }
  for (std::size_t c = count; c < blocks_.size(); ++c) doubt_.add_curve(doubt_.add_group(k_reach));
}

void Reader::measure_groups() {
  std::size_t groups = 0;
  for (std::size_t c = 0; c < told_count(); ++c) groups = std::max(groups, doubt_.group_of(c) + 1);
  asked_.assign(groups, 0.0);
  const std::size_t d = parameters_.size();
  std::vector<double> ways(d * groups, 0.0);
  for (std::size_t j = 0; j < d; ++j) {
    for (std::size_t c = 0; c < told_count(); ++c) {
      double& way = ways[j * groups + doubt_.group_of(c)];
      for (std::size_t i = blocks_[c].first; i < blocks_[c].first + blocks_[c].count; ++i)
        way = std::max(way, square_of(columns_[j * start_.size() + i]));
    }
  }
  moved_groups_.assign(d, std::vector<bool>(groups, false));
  for (std::size_t g = 0; g < groups; ++g) {
    // A whole turn of a joint goes far and says nothing of what shapes do.
    double most = 0;
    for (std::size_t j = 0; j < d; ++j) {
      if (!turns(j)) most = std::max(most, ways[j * groups + g]);
    }
    for (std::size_t j = 0; j < d; ++j)
      moved_groups_[j][g] = ways[j * groups + g] > 0.0 && ways[j * groups + g] >= k_tells * k_tells * most;
  }
}

std::vector<std::uint32_t> Reader::samples_within(double share, bool mirrored) const {
  geometry::Box model;
  for (const ModelPoint& at : whole_.fields->places()) model.add(at);
  const std::span<const ModelPoint> places = whole_.fields->places();
  std::vector<bool> is_near(places.size(), false);
  const auto mark = [&](std::span<const posing::CurvePoint> reference) {
    std::vector<ModelPoint> points = at_rest(reference);
    if (mirrored) {
      for (ModelPoint& p : points) p.x = 2.0 * model.center().x - p.x;
    }
    geometry::Box box;
    for (const ModelPoint& p : points) box.add(p);
    const double far = share * box.diagonal();
    for (std::size_t s = 0; s < places.size(); ++s) {
      const ModelPoint& at = places[s];
      const bool outside = at.x < box.minimum.x - far || at.x > box.maximum.x + far || at.y < box.minimum.y - far ||
                           at.y > box.maximum.y + far || at.z < box.minimum.z - far || at.z > box.maximum.z + far;
      if (outside || is_near[s]) continue;
      is_near[s] = std::any_of(points.begin(), points.end(),
                               [&](const ModelPoint& p) { return square_of(p - at) <= far * far; });
    }
  };
  for (const DrawnCurve& curve : problem_.drawn) mark(curve.reference);
  for (const KnownCurve& curve : problem_.known) mark(curve.reference);
  std::vector<std::uint32_t> near;
  for (std::size_t s = 0; s < places.size(); ++s) {
    if (is_near[s]) near.push_back(static_cast<std::uint32_t>(s));
  }
  return near;
}

std::vector<std::uint32_t> Reader::drawn_pieces() const {
  std::vector<std::uint32_t> pieces;
  const auto add = [&](std::span<const posing::CurvePoint> reference) {
    for (const posing::CurvePoint& point : reference) pieces.push_back(whole_.pieces[point.vertex[0]]);
  };
  if (whole_.pieces.empty()) return {0};
  for (const DrawnCurve& curve : problem_.drawn) add(curve.reference);
  for (const KnownCurve& curve : problem_.known) add(curve.reference);
  std::stable_sort(pieces.begin(), pieces.end());
  pieces.erase(std::unique(pieces.begin(), pieces.end()), pieces.end());
  return pieces;
}

void Reader::measure_fields() {
  const std::vector<std::uint32_t> pieces = drawn_pieces();
  const ControlFields& fields = *whole_.fields;
  const std::vector<std::uint32_t> near = samples_within(weights_.near);
  const std::vector<std::uint32_t> not_far = samples_within(weights_.far);
  std::vector<bool> is_distant(fields.places().size(), true);
  for (const std::uint32_t s : not_far) is_distant[s] = false;
  std::vector<bool> is_mirrored(fields.places().size(), false);
  const std::vector<std::uint32_t> images = samples_within(weights_.near, true);
  double both = 0;
  for (const std::uint32_t s : images) {
    is_mirrored[s] = true;
    if (std::binary_search(near.begin(), near.end(), s)) both += 1.0;
  }
  // Where both sides are drawn, the other side of one is near the other.
  const double one_sided = images.empty() ? 0.0 : std::max(0.0, 1.0 - 2.0 * both / static_cast<double>(images.size()));
  std::vector<std::size_t> place_in_near(fields.places().size(), near.size());
  for (std::size_t i = 0; i < near.size(); ++i) place_in_near[near[i]] = i;
  const std::size_t n = start_.size();
  std::size_t told = 0;
  for (std::size_t c = 0; c < told_count(); ++c) told += blocks_[c].count;
  for (std::size_t j = 0; j < parameters_.size(); ++j) {
    Field& one = fields_.emplace_back();
    one.near.assign(near.size(), ModelVector{0});
    // A turn about an axis of the joint's own is a sum of turns by its angles.
    const std::size_t first = turn_of_[j] == k_no_partner ? parameters_[j] : turns_[turn_of_[j]].first;
    std::array<double, 3> by{whole_.joint[parameters_[j]] == k_no_partner ? 1.0 : ranges_[j], 0.0, 0.0};
    std::size_t count = 1;
    if (turn_of_[j] != k_no_partner) {
      count = 3;
      for (std::size_t k = 0; k < 3; ++k)
        by[k] = turns_[turn_of_[j]].axes[static_cast<int>(axis_of_[j])][static_cast<int>(k)] * ranges_[j];
    }
    double whole = 0;
    double usual = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const ControlField field = fields.field(first + k);
      double farthest = 0;
      for (std::size_t i = 0; i < field.samples.size(); ++i) {
        const std::uint32_t sample = field.samples[i];
        const ModelVector way = field.ways[i] * by[k];
        if (place_in_near[sample] < near.size()) {
          one.near[place_in_near[sample]] += way;
          continue;
        }
        const double square = square_of(way);
        if (is_mirrored[sample]) one.mirrored_square += one_sided * square;
        if (is_distant[sample]) farthest = std::max(farthest, square);
      }
      one.distant_way += farthest;
      for (const WholeModel::PlaceMoved& place : whole_.places[first + k]) {
        const bool meets = std::any_of(place.samples.begin(), place.samples.end(),
                                       [&](std::uint32_t s) { return place_in_near[s] < near.size(); });
        if (!meets) one.scattered_way = std::max(one.scattered_way, by[k] * place.way);
      }
      whole += by[k] * by[k] * fields.square(first + k);
      usual += by[k] * by[k] * fields.usual_way(first + k) * fields.usual_way(first + k);
      for (const WholeModel::OfPiece& of : whole_.by_piece[first + k]) {
        if (!std::binary_search(pieces.begin(), pieces.end(), of.piece))
          one.turn = std::max(one.turn, std::abs(by[k]) * of.turn);
      }
      for (std::size_t m = 0; m < k; ++m) whole += 2.0 * by[k] * by[m] * fields.product_with_last(first + k, k - m);
    }
    for (const ModelVector& way : one.near) one.near_square += square_of(way);
    one.far_square = std::max(0.0, whole - one.near_square);
    one.distant_way = std::sqrt(one.distant_way);
    double most = 0;
    for (std::size_t i = 0; i < told; ++i) most = std::max(most, square_of(columns_[j * n + i]));
    one.usual_way = std::sqrt(usual);
    if (!turns(j) && most > 0.0) usual_way_ = std::max(usual_way_, one.usual_way);
  }
  for (const RunVariable& run : run_variables_) {
    Field one = fields_[run.parts.front().variable];
    one.near.assign(near.size(), ModelVector{0});
    for (const RunVariable::Part& part : run.parts) {
      for (std::size_t i = 0; i < near.size(); ++i) one.near[i] += fields_[part.variable].near[i] * part.by;
    }
    one.near_square = 0;
    for (const ModelVector& way : one.near) one.near_square += square_of(way);
    fields_.push_back(std::move(one));
  }
  for (Field& field : fields_) {
    for (const ModelVector& way : field.near) {
      field.ways.push_back(geometry::length(way));
      field.near_way = std::max(field.near_way, field.ways.back());
    }
  }
}

bool Reader::turns_joint(std::size_t variable, std::size_t turn) const {
  if (variable < parameters_.size()) return turn_of_[variable] == turn;
  const auto& parts = run_variables_[variable - parameters_.size()].parts;
  return std::any_of(parts.begin(), parts.end(), [&](const auto& part) { return turn_of_[part.variable] == turn; });
}

const Reader::Relation& Reader::relation(std::size_t a, std::size_t b) const {
  const std::size_t count = fields_.size();
  relations_.resize(count * (count + 1) / 2);
  const std::size_t larger = std::max(a, b);
  auto& one = relations_[larger * (larger + 1) / 2 + std::min(a, b)];
  if (one) return *one;
  one.emplace();
  const Field& own = fields_[a];
  const Field& other = fields_[b];
  const double size = std::sqrt(own.near_square * other.near_square);
  if (size > 0.0) {
    one->likeness = algebra::dot(&own.near.front().x, &other.near.front().x, 3 * own.near.size()) / size;
    one->overlap = algebra::dot(own.ways.data(), other.ways.data(), own.ways.size()) / size;
  }
  for (std::size_t t = 0; t < turns_.size(); ++t) {
    if (turns_joint(a, t) && turns_joint(b, t)) one->likeness = 1.0;
  }
  return *one;
}

std::size_t Reader::parameter_of(std::size_t variable) const {
  return variable < parameters_.size() ? variable
                                       : run_variables_[variable - parameters_.size()].parts.front().variable;
}

bool Reader::carries_more(const Unit& unit) const {
  double near = 0;
  double far = 0;
  for (std::size_t m = 0; m < unit.count; ++m) {
    const std::size_t v = parameter_of(unit.members[m]);
    if (whole_.joint[parameters_[v]] == k_no_partner) return false;
    near += fields_[v].near_square;
    far += fields_[v].far_square;
  }
  return far > weights_.carries_more * near;
}

void Reader::leave_carriers(bool out) {
  if (!out) {
    choices_.units.insert(choices_.units.end(), carriers_.begin(), carriers_.end());
    carriers_.clear();
    return;
  }
  std::copy_if(choices_.units.begin(), choices_.units.end(), std::back_inserter(carriers_),
               [&](const Unit& unit) { return carries_more(unit); });
  std::erase_if(choices_.units, [&](const Unit& unit) { return carries_more(unit); });
}

bool Reader::others_follow() const {
  const auto moves = [&](const Block& block, const Unit& unit, double least) {
    for (std::size_t m = 0; m < unit.count; ++m) {
      const auto column = std::span(columns_).subspan(parameter_of(unit.members[m]) * start_.size() + block.first);
      for (std::size_t i = 0; i < block.count; ++i) {
        if (geometry::length(column[i]) >= least) return true;
      }
    }
    return false;
  };
  for (std::size_t c = 0; c < told_count(); ++c) {
    const Block& block = blocks_[c];
    double asked = 0;
    if (block.drawn != nullptr) {
      const geometry::Camera& camera = block.drawn->camera;
      asked = way_across(seen(block, start_), block.drawn->target) *
              camera.units_per_px(std::max(0.0, camera.depth(start_[block.first])));
    } else {
      for (std::size_t i = 0; i < block.count; ++i)
        asked = std::max(asked, geometry::distance(start_[block.first + i], block.known->target[i]));
    }
    for (const Unit& unit : choices_.units) {
      if (!carries_more(unit) && moves(block, unit, weights_.follows * asked)) return true;
    }
  }
  return false;
}

double Reader::stiffness(bool settled) const {
  const double share = weights_.by[Term::share];
  return settled ? std::min(weights_.settled_share, share) : share;
}

void Reader::settle(bool settled) {
  for (std::size_t j = 0; j < parameters_.size(); ++j) {
    if (turn_of_[j] == k_no_partner) choices_.stiffness[j] = stiffness(settled);
  }
}

void Reader::charge_face(Unit& unit, bool by_axes) const {
  double near = 0, near_way = 0, far = 0, distant = 0, mirrored = 0, turn = 0, scattered = 0, parts = 1, usual = 0,
         bears = 0;
  for (std::size_t m = 0; m < unit.count; ++m) {
    const std::size_t v = parameter_of(unit.members[m]);
    near += fields_[v].near_square;
    far += fields_[v].far_square;
    near_way = std::max(near_way, fields_[v].near_way);
    distant = std::max(distant, fields_[v].distant_way);
    mirrored += fields_[v].mirrored_square;
    turn = std::max(turn, fields_[v].turn);
    scattered = std::max(scattered, fields_[v].scattered_way);
    bears = std::max(bears, whole_.bears[parameters_[v]]);
    usual = std::max(usual, fields_[v].usual_way);
    parts = std::max(parts, whole_.composites[parameters_[v]].parts);
  }
  const double elsewhere = near > 0.0 ? far / near : k_no_share;
  inference::Terms& terms = unit.terms;
  terms = {};
  terms[Term::unit] = 1.0;
  terms[Term::elsewhere] = base::log(1.0 + elsewhere);
  terms[Term::mirrored] = base::log(1.0 + (near > 0.0 ? mirrored / near : 0.0));
  const auto beside_near = [&](double way) {
    const double share = near_way > 0.0 ? std::min(way / near_way, k_no_share) : way > 0.0 ? k_no_share : 0.0;
    return base::log(1.0 + share * share);
  };
  terms[Term::distant] = beside_near(distant);
  terms[Term::turned] = beside_near(turn);
  terms[Term::scattered] = beside_near(scattered);
  const std::size_t first = parameter_of(unit.members[0]);
  if (unit.count == 1 && whole_.partner[parameters_[first]] == k_no_partner && !turns(unit.members[0]))
    terms[Term::lone] = 1.0;
  if (usual > 0.0) terms[Term::faint] = base::log(std::max(1.0, usual_way_ / usual));
  terms[Term::bears] = bears * bears;
  terms[Term::part] = parts - 1.0;
  for (std::size_t m = 0; m < unit.count; ++m) {
    const std::size_t p = parameters_[parameter_of(unit.members[m])];
    if (!problem_.taught.empty()) terms[Term::taught] += problem_.taught[p];
    if (!(whole_.contacts->depth(p) > weights_.crosses_from)) continue;
    const double deep = whole_.contacts->depth(p, shares_at_start_);
    terms[Term::crosses] += std::clamp(deep / weights_.crosses_from - 1.0, 0.0, 1.0);
  }
  if (turns(unit.members[0])) terms[Term::carried] = base::log(1.0 + elsewhere / weights_.carried_from);
  if (by_axes) terms[Term::axis] = static_cast<double>(unit.count);
  // The sides of a pair that pull against each other.
  if (unit.tied) terms[Term::against] = std::max(0.0, -likeness(unit.members[0], unit.members[1]) - 0.1);
  terms[Term::lopsided] = asymmetry_of(unit);
  unit.charge = weights_.by.dot(terms);
}

}  // namespace penpose::intent
