#include "core/intent/reader.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/math.h"
#include "core/curve/pairing.h"
#include "core/intent/view_rows.h"

namespace penpose::intent {
namespace {

/// Weight along the ray beside that across it: a line says next to nothing about depth.
constexpr double k_ray = 0.02;
constexpr std::size_t k_modes = Matching::k_modes;
/// What the square of a variable costs, as shares of ranges: no more than what keeps undetermined ones where they are.
constexpr double k_stiffness = 0.5;

double dot(PxPoint a, PxPoint b) { return a.x * b.x + a.y * b.y; }
PxPoint across(PxPoint tangent) { return {-tangent.y, tangent.x}; }

posing::PoseProblem points_of(const IntentProblem& problem) {
  posing::PoseProblem plain;
  const auto add = [&](const std::vector<posing::CurvePoint>& reference) {
    plain.pairs.push_back({reference, std::vector<ModelPoint>(reference.size(), ModelPoint{0}), {}});
  };
  for (const DrawnCurve& curve : problem.drawn) add(curve.reference);
  for (const KnownCurve& curve : problem.known) add(curve.reference);
  for (const KnownCurve& curve : problem.kept) add(curve.reference);
  plain.free = problem.free;
  plain.start = problem.start;
  return plain;
}

/// Lower Cholesky factor of I + M.
std::array<Matching::Modes, k_modes> cholesky(std::array<Matching::Modes, k_modes> m) {
  for (std::size_t i = 0; i < k_modes; ++i) m[i][i] += 1.0;
  for (std::size_t i = 0; i < k_modes; ++i) {
    for (std::size_t c = 0; c <= i; ++c) {
      double sum = m[i][c];
      for (std::size_t k = 0; k < c; ++k) sum -= m[i][k] * m[c][k];
      m[i][c] = i == c ? std::sqrt(sum) : sum / m[c][c];
    }
  }
  return m;
}

/// L^-1 b in place.
void forward(const std::array<Matching::Modes, k_modes>& l, double* b) {
  for (std::size_t i = 0; i < k_modes; ++i) {
    for (std::size_t k = 0; k < i; ++k) b[i] -= l[i][k] * b[k];
    b[i] /= l[i][i];
  }
}

}  // namespace

Reader::Reader(const rig::Rig& rig, const WholeModel& whole, const IntentProblem& problem)
    : rig_(rig), whole_(whole), problem_(problem), system_(rig, points_of(problem)) {
  std::size_t first = 0;
  const auto add = [&](const std::vector<posing::CurvePoint>& reference) -> Block& {
    Block block;
    block.first = first;
    block.count = reference.size();
    first += block.count;
    blocks_.push_back(std::move(block));
    return blocks_.back();
  };
  start_.resize(system_.point_count());
  positions_.resize(start_.size());
  moved_.resize(start_.size());
  system_.positions(problem.start, start_);
  for (const DrawnCurve& curve : problem.drawn) {
    Block& block = add(curve.reference);
    block.drawn = &curve;
    block.doubt = curve.doubt_px;
    block.line.emplace(curve.target);
    block.alignments =
        intent::alignments(seen(block, start_), curve.target, curve::pairing_distance_px(curve.camera.viewport()));
  }
  for (const auto* curves : {&problem.known, &problem.kept}) {
    for (const KnownCurve& curve : *curves) {
      Block& block = add(curve.reference);
      block.known = &curve;
      block.doubt = curve.doubt;
    }
  }

  std::vector<std::size_t> candidates;
  for (const std::size_t p : problem.free) {
    const rig::Parameter& parameter = rig.parameters()[p];
    if (system_.moves(p) && parameter.maximum > parameter.minimum) candidates.push_back(p);
  }
  parameters_ = candidates;
  for (const std::size_t p : parameters_) ranges_.push_back(rig.parameters()[p].maximum - rig.parameters()[p].minimum);
  for (std::size_t j = 0; j < parameters_.size(); ++j) all_.push_back(j);
  linear_ = true;
  make_columns(problem.start, all_);

  // Parameters that move no point by a hundred thousandth of the curves' extent are left out.
  geometry::Box box;
  for (const ModelPoint& p : start_) box.add(p);
  const double least = 1e-5 * box.diagonal();
  const std::size_t n = start_.size();
  std::vector<std::size_t> kept;
  std::vector<double> kept_ranges;
  std::vector<ModelVector> kept_columns;
  for (std::size_t j = 0; j < parameters_.size(); ++j) {
    const std::span column(columns_.data() + j * n, n);
    const bool moves = std::any_of(column.begin(), column.end(), [&](const ModelVector& v) {
      return geometry::length(v) > least && std::isfinite(v.x + v.y + v.z);
    });
    if (!moves) continue;
    kept.push_back(parameters_[j]);
    kept_ranges.push_back(ranges_[j]);
    kept_columns.insert(kept_columns.end(), column.begin(), column.end());
  }
  parameters_ = std::move(kept);
  ranges_ = std::move(kept_ranges);
  columns_ = std::move(kept_columns);
  all_.resize(parameters_.size());
  make_units();
}

void Reader::make_units() {
  const std::size_t d = parameters_.size();
  for (std::size_t j = 0; j < d; ++j) {
    const std::size_t p = parameters_[j];
    const rig::Parameter& parameter = rig_.parameters()[p];
    choices_.low.push_back(std::min(0.0, (parameter.minimum - problem_.start[p]) / ranges_[j]));
    choices_.high.push_back(std::max(0.0, (parameter.maximum - problem_.start[p]) / ranges_[j]));
    choices_.movement.push_back(whole_.movement[p]);
    choices_.stiffness.push_back(k_stiffness);
  }
  const auto variable_of = [&](std::size_t p) -> std::size_t {
    const auto at = std::lower_bound(parameters_.begin(), parameters_.end(), p);
    return at != parameters_.end() && *at == p ? static_cast<std::size_t>(at - parameters_.begin()) : k_no_partner;
  };
  for (std::size_t j = 0; j < d;) {
    const std::size_t p = parameters_[j];
    Unit unit;
    unit.members[0] = j;
    if (whole_.joint[p] != k_no_partner) {
      while (unit.count < 3 && j + unit.count < d && whole_.group[parameters_[j + unit.count]] == whole_.group[p]) {
        unit.members[unit.count] = j + unit.count;
        ++unit.count;
      }
    }
    choices_.units.push_back(unit);
    j += unit.count;
  }
  for (std::size_t j = 0; j < d; ++j) {
    const std::size_t partner = whole_.partner[parameters_[j]];
    if (whole_.joint[parameters_[j]] != k_no_partner || partner == k_no_partner) continue;
    const std::size_t other = variable_of(partner);
    if (other == k_no_partner || other <= j) continue;
    Unit unit;
    unit.members = {j, other, 0};
    unit.count = 2;
    unit.tied = true;
    choices_.units.push_back(unit);
  }
}

void Reader::restrict_to(std::span<const std::size_t> joints) {
  choices_.units.clear();
  choices_.low.clear();
  choices_.high.clear();
  choices_.movement.clear();
  choices_.stiffness.clear();
  make_units();
  if (joints.empty()) return;
  std::erase_if(choices_.units, [&](const Unit& unit) {
    const std::size_t joint = whole_.joint[parameters_[unit.members[0]]];
    return joint != k_no_partner && std::find(joints.begin(), joints.end(), joint) == joints.end();
  });
}

void Reader::redraw(std::size_t c, std::span<const PxPoint> line, Alignment alignment) {
  Block& block = blocks_[c];
  block.line.emplace(line);
  block.alignments.assign(1, alignment);
  block.aligned = 0;
}

std::vector<PxPoint> Reader::seen(const Block& block, std::span<const ModelPoint> positions) const {
  std::vector<PxPoint> out(block.count);
  for (std::size_t i = 0; i < block.count; ++i) {
    // A point that a pose takes behind the eye is seen at the edge of what is seen at all; check_problem refuses those
    // that start there.
    const auto px = block.drawn->camera.project(positions[block.first + i]);
    out[i] = px ? *px : PxPoint{-1e6, -1e6};
  }
  return out;
}

void Reader::make_columns(const rig::Pose& pose, std::span<const std::size_t> variables) {
  const std::size_t n = start_.size();
  columns_.resize(parameters_.size() * n, ModelVector{0});
  if (linear_) {
    if (const auto columns = system_.columns(pose, parameters_)) {
      for (std::size_t j = 0; j < parameters_.size(); ++j) {
        const posing::Residuals& values = (*columns)[j].values();
        for (std::size_t i = 0; i < n; ++i) {
          columns_[j * n + i] = ModelVector{values[posing::residual_index(i, 0)], values[posing::residual_index(i, 1)],
                                            values[posing::residual_index(i, 2)]} *
                                ranges_[j];
        }
      }
      return;
    }
    linear_ = false;
  }
  // Differences over a ten thousandth of the range, inwards.
  rig::Pose trial = pose;
  system_.positions(trial, positions_);
  for (const std::size_t j : variables) {
    const std::size_t p = parameters_[j];
    const double middle = 0.5 * (rig_.parameters()[p].minimum + rig_.parameters()[p].maximum);
    const double step = pose[p] > middle ? -1e-4 : 1e-4;
    trial[p] = pose[p] + step * ranges_[j];
    system_.positions(trial, moved_);
    trial[p] = pose[p];
    for (std::size_t i = 0; i < n; ++i) columns_[j * n + i] = (moved_[i] - positions_[i]) * (1.0 / step);
  }
}

rig::Pose Reader::pose_of(const Choice& choice) const {
  rig::Pose pose = problem_.start;
  for (std::size_t i = 0; i < choice.variables.size(); ++i) {
    if (choice.values[i] == 0.0) continue;
    const std::size_t p = parameters_[choice.variables[i]];
    const rig::Parameter& parameter = rig_.parameters()[p];
    pose[p] = std::clamp(problem_.start[p] + choice.values[i] * ranges_[choice.variables[i]], parameter.minimum,
                         parameter.maximum);
  }
  return pose;
}

void Reader::look(const Choice& at, bool slide, Quadratic& quadratic, std::span<const std::size_t> only) {
  const rig::Pose pose = pose_of(at);
  const std::span<const std::size_t> variables = only.empty() ? std::span<const std::size_t>(all_) : only;
  if (!linear_) make_columns(pose, variables);
  system_.positions(pose, positions_);
  std::size_t rows = 0;
  std::size_t slides = 0;
  for (Block& block : blocks_) {
    block.row = rows;
    block.slide = slides;
    rows += 3 * block.count;
    if (block.drawn) slides += k_modes;
  }
  quadratic.reset(parameters_.size(), rows, slides);
  std::vector<double> z(parameters_.size(), 0.0);
  for (std::size_t i = 0; i < at.variables.size(); ++i) z[at.variables[i]] = at.values[i];
  for (Block& block : blocks_) {
    if (block.drawn) {
      look_at_drawn(block, quadratic, z, slide, variables);
    } else {
      look_at_known(block, quadratic, z, variables);
    }
  }
  quadratic.finish(only);
}

void Reader::look_at_drawn(Block& block, Quadratic& quadratic, std::span<const double> at, bool slide,
                           std::span<const std::size_t> variables) {
  const std::size_t n = start_.size();
  const std::vector<PxPoint> px = seen(block, positions_);
  block.matching = block.line->match(px, block.alignments[block.aligned], slide, block.doubt / std::sqrt(block.share));
  Matching& m = block.matching;
  std::array<Matching::Modes, k_modes> grown{};
  const auto& weights = block.drawn->weights;
  for (std::size_t i = 0; i < block.count; ++i) {
    if (!weights.empty()) m.weight[i] *= weights[i];
    const double w = block.share * m.weight[i] * k_looks / (block.doubt * block.doubt);
    const double root = std::sqrt(w);
    const std::size_t row = block.row + 3 * i;
    const auto d = view_derivative(block.drawn->camera, positions_[block.first + i]);
    if (!d) {
      m.weight[i] = 0;
      continue;
    }
    for (std::size_t a = 0; a < k_modes; ++a) {
      for (std::size_t b = 0; b < k_modes; ++b) grown[a][b] += w * m.modes[i][a] * m.modes[i][b];
    }
    const ModelVector normal = (d->x * across(m.tangent[i]).x + d->y * across(m.tangent[i]).y) * root;
    const ModelVector along = (d->x * m.tangent[i].x + d->y * m.tangent[i].y) * root;
    const ModelVector ray = d->ray * (root * k_ray);
    const PxPoint off = m.goal[i] - px[i];
    double rn = dot(off, across(m.tangent[i])) * root;
    double rt = (dot(off, m.tangent[i]) - m.slid[i]) * root;
    double rr = -glm::dot(ray, positions_[block.first + i] - start_[block.first + i]);
    for (const std::size_t j : variables) {
      const ModelVector& c = columns_[j * n + block.first + i];
      const auto column = quadratic.column(j);
      column[row] = glm::dot(normal, c);
      column[row + 1] = glm::dot(along, c);
      column[row + 2] = glm::dot(ray, c);
      if (at[j] == 0.0) continue;
      rn += column[row] * at[j];
      rt += column[row + 1] * at[j];
      rr += column[row + 2] * at[j];
    }
    quadratic.right()[row] = rn;
    quadratic.right()[row + 1] = rt;
    quadratic.right()[row + 2] = rr;
  }
  block.factor = cholesky(grown);
  const auto slides = [&](std::span<double> numbers) {
    double* out = numbers.data() + quadratic.rows() + block.slide;
    for (std::size_t i = 0; i < block.count; ++i) {
      const double w = block.share * m.weight[i] * k_looks / (block.doubt * block.doubt);
      const double t = std::sqrt(w) * numbers[block.row + 3 * i + 1];
      if (t == 0.0) continue;
      for (std::size_t a = 0; a < k_modes; ++a) out[a] += m.modes[i][a] * t;
    }
    forward(block.factor, out);
  };
  for (const std::size_t j : variables) slides(quadratic.column(j));
  slides(quadratic.right());
}

void Reader::look_at_known(Block& block, Quadratic& quadratic, std::span<const double> at,
                           std::span<const std::size_t> variables) {
  const std::size_t n = start_.size();
  const double root = std::sqrt(block.share * k_looks / static_cast<double>(block.count)) / block.doubt;
  for (std::size_t i = 0; i < block.count; ++i) {
    const ModelVector off = (block.known->target[i] - positions_[block.first + i]) * root;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t row = block.row + 3 * i + axis;
      const int k = static_cast<int>(axis);
      double right = off[k];
      for (const std::size_t j : variables) {
        const double c = columns_[j * n + block.first + i][k] * root;
        quadratic.column(j)[row] = c;
        if (at[j] != 0.0) right += c * at[j];
      }
      quadratic.right()[row] = right;
    }
  }
}

double Reader::squares(const Block& block, std::span<const ModelPoint> positions) const {
  double sum = 0;
  if (block.known) {
    for (std::size_t i = 0; i < block.count; ++i) {
      const ModelVector off = block.known->target[i] - positions[block.first + i];
      sum += glm::dot(off, off);
    }
    return sum * k_looks / static_cast<double>(block.count) / (block.doubt * block.doubt);
  }
  const Matching& m = block.matching;
  std::array<Matching::Modes, k_modes> grown{};
  Matching::Modes back{};
  for (std::size_t i = 0; i < block.count; ++i) {
    if (m.weight[i] == 0.0) continue;
    const double w = m.weight[i] * k_looks / (block.doubt * block.doubt);
    const auto px = block.drawn->camera.project(positions[block.first + i]);
    const PxPoint off = m.goal[i] - (px ? *px : PxPoint{-1e6, -1e6});
    const double normal = dot(off, across(m.tangent[i]));
    const double along = dot(off, m.tangent[i]) - m.slid[i];
    sum += w * (normal * normal + along * along);
    for (std::size_t a = 0; a < k_modes; ++a) {
      back[a] += w * m.modes[i][a] * along;
      for (std::size_t b = 0; b <= a; ++b) grown[a][b] += w * m.modes[i][a] * m.modes[i][b];
    }
  }
  forward(cholesky(grown), back.data());
  for (const double b : back) sum -= b * b;
  return std::max(sum, 0.0);
}

double Reader::energy(const Choice& choice, double costs) {
  system_.positions(pose_of(choice), positions_);
  double sum = costs;
  for (const Block& block : blocks_) {
    sum += k_reach * base::log(1.0 + squares(block, positions_) / k_reach);
    if (block.drawn) sum += block.alignments[block.aligned].charge;
  }
  for (std::size_t i = 0; i < choice.variables.size(); ++i)
    sum += choices_.stiffness[choice.variables[i]] * choice.values[i] * choice.values[i];
  return sum;
}

double Reader::energy_of_image(std::span<const double> image, std::size_t rows) const {
  double sum = 0;
  for (const Block& block : blocks_) {
    const double* a = image.data() + block.row;
    double squares = posing::dot(a, a, 3 * block.count);
    if (block.drawn) {
      const double* b = image.data() + rows + block.slide;
      squares -= posing::dot(b, b, k_modes);
    }
    sum += k_reach * base::log(1.0 + std::max(squares, 0.0) / (block.share * k_reach));
  }
  return sum;
}

double Reader::squares_of(std::size_t c, const Choice& choice) {
  system_.positions(pose_of(choice), positions_);
  return squares(blocks_[c], positions_);
}

void Reader::weigh(const Choice& choice) {
  system_.positions(pose_of(choice), positions_);
  for (Block& block : blocks_) block.share = 1.0 / (1.0 + squares(block, positions_) / k_reach);
}

Reader::Left Reader::left(const rig::Pose& pose) {
  system_.positions(pose, positions_);
  Left left;
  for (Block& block : blocks_) {
    double px_sum = 0;
    double sum = 0;
    std::size_t count = 0;
    std::vector<PxPoint> px;
    Matching m;
    if (block.drawn) {
      px = seen(block, positions_);
      m = block.line->match(px, block.alignments[block.aligned], true, block.doubt);
    }
    for (std::size_t i = 0; i < block.count; ++i) {
      const ModelPoint& at = positions_[block.first + i];
      double distance = 0;
      if (block.drawn) {
        if (m.weight[i] == 0.0) continue;
        const double in_picture = geometry::distance(m.goal[i], px[i]);
        px_sum += in_picture;
        distance = in_picture * block.drawn->camera.units_per_px(std::max(0.0, block.drawn->camera.depth(at)));
      } else {
        distance = geometry::distance(block.known->target[i], at);
      }
      ++count;
      sum += distance;
      left.longest = std::max(left.longest, distance);
    }
    const double n = static_cast<double>(std::max<std::size_t>(count, 1));
    left.px.push_back(px_sum / n);
    left.units.push_back(sum / n);
    left.sum += sum;
  }
  return left;
}

}  // namespace penpose::intent
