#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/algebra/vectors.h"
#include "core/base/math.h"
#include "core/intent/line/view_rows.h"
#include "core/intent/reading/reader.h"

// Looking at the curves: squares near a pose, and the energy at one.

namespace penpose::intent {
namespace {

/// Rows along the ray beside those across it: a line says next to nothing about depth.
constexpr double k_ray = 0.02;
/// Of an overshoot: where it lies, and how far it bends.
constexpr std::size_t k_overshoot_rows = 2;
/// With as many squares as this an overshoot of the curve as it is tells where its end should be; that end then slides
/// by so much of what ends do.
constexpr double k_overshoot_tells = 3.0, k_told_end = 0.35;

PxPoint across(PxPoint tangent) { return {-tangent.y, tangent.x}; }

}  // namespace

double Reader::doubt_of(const Block& block) { return block.doubt * block.alignments[block.aligned].rough; }

void Reader::look(const Choice& at, bool slide, Quadratic& quadratic, std::span<const std::size_t> only) {
  const rig::Pose pose = pose_of(at);
  const std::span<const std::size_t> variables = only.empty() ? std::span<const std::size_t>(all_) : only;
  std::vector<double> z(variable_count(), 0.0);
  for (std::size_t i = 0; i < at.variables.size(); ++i) z[at.variables[i]] = at.values[i];
  if (!linear_) make_columns(pose, z, variables);
  place(pose, positions_);
  std::size_t rows = 0;
  std::size_t slides = 0;
  for (Block& block : blocks_) {
    block.row = rows;
    block.slide = slides;
    block.rows = 3 * block.count;
    if (block.drawn && overshoots_tell()) block.rows += 2 * k_overshoot_rows;
    rows += block.rows;
    if (block.drawn) slides += k_modes;
  }
  quadratic.reset(variable_count(), rows + lean_count(), slides);
  if (!limb()) {
    std::vector<Quadratic::Part> parts;
    for (const Block& block : blocks_)
      parts.push_back({block.row, block.rows, block.slide, block.drawn != nullptr ? k_modes : 0});
    parts.push_back({rows, lean_count(), slides, 0});
    quadratic.split(parts);
  }
  for (Block& block : blocks_) {
    if (block.drawn) {
      look_at_drawn(block, quadratic, z, slide, variables);
    } else {
      look_at_known(block, quadratic, z, variables);
    }
  }
  look_at_leans(quadratic, rows, z);
  quadratic.finish(only);
}

void Reader::tell_ends(Block& block) const {
  const std::vector<PxPoint> px = seen(block, start_);
  const auto& stays = block.drawn->stays;
  for (Alignment& one : block.alignments) {
    const double doubt = block.doubt * one.rough;
    const Matching m = block.line->match(px, one, true, doubt);
    const auto beyond = overshoots(*block.line, px, one, m, doubt);
    for (std::size_t end = 0; end < 2; ++end) {
      if (!stays.empty() && stays[beyond[end].end]) continue;
      if (squares_of(beyond[end], px[beyond[end].end], doubt) >= k_overshoot_tells) one.ends_slide[end] = k_told_end;
    }
  }
}

bool Reader::ends_told(std::size_t c) const {
  const auto& slides = blocks_[c].alignments.front().ends_slide;
  return slides[0] < 1.0 || slides[1] < 1.0;
}

double Reader::squares_of(const Overshoot& one, PxPoint end, double doubt) {
  if (one.share == 0.0) return 0.0;
  const double off = dot(one.middle - end, one.across);
  return one.share * k_looks / (doubt * doubt) * (off * off + one.spread);
}

double Reader::overshoot_squares(const Block& block, std::span<const ModelPoint> positions) const {
  double sum = 0;
  for (const Overshoot& one : block.overshoots) {
    const auto px = block.drawn->camera.project(positions[block.first + one.end]);
    sum += squares_of(one, px ? *px : PxPoint{-1e6, -1e6}, doubt_of(block));
  }
  return sum;
}

void Reader::look_at_drawn(Block& block, Quadratic& quadratic, std::span<const double> at, bool slide,
                           std::span<const std::size_t> variables) {
  const std::size_t n = start_.size();
  const std::vector<PxPoint> px = seen(block, positions_);
  const double doubt = doubt_of(block);
  match(block, px, slide);
  Matching& m = block.matching;
  ModeMatrix grown{};
  rows_.assign(block.count, {});
  const std::span<double> right = quadratic.right();
  for (std::size_t i = 0; i < block.count; ++i) {
    const double w = block.share * m.weight[i] * k_looks / (doubt * doubt);
    const double root = std::sqrt(w);
    const std::size_t row = block.row + 3 * i;
    const auto d = view_derivative(block.drawn->camera, positions_[block.first + i]);
    if (!d) {
      m.weight[i] = 0;
      continue;
    }
    grow(grown, m.modes[i], w);
    if (!m.across.empty()) grown.back().back() += w * m.across[i] * m.across[i];
    PointRows& rows = rows_[i];
    rows.root = root;
    rows.normal = (d->x * across(m.tangent[i]).x + d->y * across(m.tangent[i]).y) * root;
    rows.along = (d->x * m.tangent[i].x + d->y * m.tangent[i].y) * root;
    rows.ray = d->ray * (root * k_ray);
    const PxPoint off = m.target[i] - px[i];
    right[row] = dot(off, across(m.tangent[i])) * root;
    right[row + 1] = (dot(off, m.tangent[i]) - m.slid[i]) * root;
    right[row + 2] = -glm::dot(rows.ray, positions_[block.first + i] - start_[block.first + i]);
  }
  for (const std::size_t j : variables) {
    const ModelVector* ways = columns_.data() + j * n + block.first;
    double* out = quadratic.column(j).data() + block.row;
    double* residual = right.data() + block.row;
    for (std::size_t i = 0; i < block.count; ++i) {
      const PointRows& rows = rows_[i];
      out[3 * i] = glm::dot(rows.normal, ways[i]);
      out[3 * i + 1] = glm::dot(rows.along, ways[i]);
      out[3 * i + 2] = glm::dot(rows.ray, ways[i]);
    }
    if (at[j] == 0.0) continue;
    for (std::size_t k = 0; k < 3 * block.count; ++k) residual[k] += out[k] * at[j];
  }
  if (overshoots_tell()) look_at_overshoots(block, px, quadratic, at, variables);
  block.factor = factor_of(grown);
  const auto slides = [&](std::span<double> numbers) {
    Modes sums{};
    for (std::size_t i = 0; i < block.count; ++i) {
      const double t = rows_[i].root * numbers[block.row + 3 * i + 1];
      if (t == 0.0 && m.across.empty()) continue;
      for (std::size_t a = 0; a < k_modes; ++a) sums[a] += m.modes[i][a] * t;
      if (!m.across.empty()) sums[k_modes - 1] += m.across[i] * rows_[i].root * numbers[block.row + 3 * i];
    }
    solve_forward(block.factor, sums.data());
    std::copy(sums.begin(), sums.end(), numbers.data() + quadratic.rows() + block.slide);
  };
  for (const std::size_t j : variables) slides(quadratic.column(j));
  slides(right);
}

void Reader::look_at_overshoots(Block& block, std::span<const PxPoint> px, Quadratic& quadratic,
                                std::span<const double> at, std::span<const std::size_t> variables) {
  const std::size_t n = start_.size();
  std::size_t row = block.row + 3 * block.count;
  for (const Overshoot& one : block.overshoots) {
    const std::size_t point = block.first + one.end;
    const auto d = one.share > 0.0 ? view_derivative(block.drawn->camera, positions_[point]) : std::nullopt;
    if (d) {
      const double root = std::sqrt(block.share * one.share * k_looks) / doubt_of(block);
      const ModelVector across = (d->x * one.across.x + d->y * one.across.y) * root;
      double right = dot(one.middle - px[one.end], one.across) * root;
      for (const std::size_t j : variables) {
        const double c = glm::dot(across, columns_[j * n + point]);
        quadratic.column(j)[row] = c;
        if (at[j] != 0.0) right += c * at[j];
      }
      quadratic.right()[row] = right;
      quadratic.right()[row + 1] = std::sqrt(one.spread) * root;
    }
    row += k_overshoot_rows;
  }
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
  ModeMatrix grown{};
  Modes back{};
  const double doubt = doubt_of(block);
  for (std::size_t i = 0; i < block.count; ++i) {
    if (m.weight[i] == 0.0) continue;
    const double w = m.weight[i] * k_looks / (doubt * doubt);
    const auto px = block.drawn->camera.project(positions[block.first + i]);
    const PxPoint off = m.target[i] - (px ? *px : PxPoint{-1e6, -1e6});
    const double normal = dot(off, across(m.tangent[i]));
    const double along = dot(off, m.tangent[i]) - m.slid[i];
    sum += w * (normal * normal + along * along);
    for (std::size_t a = 0; a < k_modes; ++a) back[a] += w * m.modes[i][a] * along;
    grow(grown, m.modes[i], w);
    if (m.across.empty()) continue;
    back[k_modes - 1] += w * m.across[i] * normal;
    grown.back().back() += w * m.across[i] * m.across[i];
  }
  solve_forward(factor_of(grown), back.data());
  for (const double b : back) sum -= b * b;
  if (overshoots_tell()) sum += overshoot_squares(block, positions);
  return std::max(sum, 0.0);
}

double Reader::energy(const Choice& choice, double costs) {
  place(pose_of(choice), positions_);
  double sum = costs + energy_as_placed();
  if (!limb()) return sum + reading_costs().stiffness_of(choice) + lean_cost(choice);
  for (std::size_t i = 0; i < choice.variables.size(); ++i)
    sum += choices_.stiffness[choice.variables[i]] * choice.values[i] * choice.values[i];
  return turns_.empty() ? sum : sum + lean_cost(choice);
}

inference::Terms Reader::terms_of(const Choice& choice) {
  energy_at(pose_of(choice));
  place(pose_of(choice), positions_);
  std::vector<double> all;
  inference::Terms terms = reading_costs().terms_of(choice);
  for (const Block& block : blocks_) {
    all.push_back(squares(block, positions_));
    if (block.drawn) terms += block.alignments[block.aligned].terms;
  }
  terms[inference::Term::evidence] = doubt_.energy(all);
  terms[inference::Term::leaning] += lean_cost(choice);
  return terms;
}

double Reader::matched_energy(const Choice& choice, double costs) {
  energy_at(pose_of(choice));
  return energy(choice, costs);
}

double Reader::energy_as_placed() const {
  double sum = 0;
  std::vector<double> all;
  for (const Block& block : blocks_) {
    all.push_back(squares(block, positions_));
    if (limb()) sum += k_reach * base::log(1.0 + all.back() / k_reach);
    if (block.drawn) sum += block.alignments[block.aligned].charge;
  }
  return limb() ? sum : sum + doubt_.energy(all);
}

double Reader::energy_at(const rig::Pose& pose) {
  place(pose, positions_);
  for (Block& block : blocks_) {
    if (block.drawn != nullptr) match(block, seen(block, positions_), true);
  }
  return energy_as_placed();
}

std::vector<double> Reader::squares_left(const Choice& choice) {
  energy_at(pose_of(choice));
  std::vector<double> left;
  for (std::size_t c = 0; c < told_count(); ++c) left.push_back(squares(blocks_[c], positions_));
  return left;
}

void Reader::match(Block& block, std::span<const PxPoint> px, bool slide) const {
  const Alignment& alignment = block.alignments[block.aligned];
  Matching& m = block.matching;
  m = block.line->match(px, alignment, slide, doubt_of(block) / std::sqrt(block.share));
  const auto& weights = block.drawn->weights;
  for (std::size_t i = 0; i < weights.size(); ++i) m.weight[i] *= weights[i];
  if (overshoots_tell()) block.overshoots = overshoots(*block.line, px, alignment, m, doubt_of(block));
  leave_still(block, m);
  if (block.drawn->stays.empty()) return;
  for (Overshoot& one : block.overshoots) one.share = block.drawn->stays[one.end] ? 0.0 : one.share;
}

void Reader::leave_still(const Block& block, Matching& m) {
  const auto& stays = block.drawn->stays;
  for (std::size_t i = 0; i < stays.size(); ++i) m.weight[i] = stays[i] ? 0.0 : m.weight[i];
}

double Reader::energy_of_image(std::span<const double> image, std::size_t rows) const {
  double sum = 0;
  std::vector<double> all;
  for (const Block& block : blocks_) {
    const double* a = image.data() + block.row;
    double squares = algebra::dot(a, a, block.rows);
    if (block.drawn) {
      const double* b = image.data() + rows + block.slide;
      squares -= algebra::dot(b, b, k_modes);
    }
    if (!limb()) {
      all.push_back(squares);
      continue;
    }
    sum += k_reach * base::log(1.0 + std::max(squares, 0.0) / (block.share * k_reach));
  }
  return limb() ? sum : doubt_.energy(all);
}

bool Reader::takes_shape(std::size_t c, const Choice& choice) {
  place(pose_of(choice), positions_);
  const Block& block = blocks_[c];
  const Matching& m = block.matching;
  if (m.across.empty()) return true;
  double moved = 0, all = 0, off = 0, grown = 1;
  for (std::size_t i = 0; i < block.count; ++i) {
    const auto before = block.drawn->camera.project(start_[block.first + i]);
    const auto now = block.drawn->camera.project(positions_[block.first + i]);
    if (!before || !now || m.weight[i] == 0.0) continue;
    const PxPoint way = *now - *before;
    moved += m.weight[i] * dot(way, way);
    all += m.weight[i];
    const double w = m.weight[i] * k_looks / (doubt_of(block) * doubt_of(block));
    off += w * m.across[i] * dot(m.target[i] - *now, across(m.tangent[i]));
    grown += w * m.across[i] * m.across[i];
  }
  const double offset = block.alignments[block.aligned].offset_px * off / grown;
  return all > 0.0 && std::sqrt(moved / all) >= std::abs(offset);
}

double Reader::squares_of(std::size_t c, const Choice& choice) { return squares_at(c, pose_of(choice)); }

double Reader::squares_at(std::size_t c, const rig::Pose& pose) {
  place(pose, positions_);
  return squares(blocks_[c], positions_);
}

void Reader::weigh_evenly() {
  for (Block& block : blocks_) block.share = 1.0;
}

void Reader::weigh(const Choice& choice) {
  place(pose_of(choice), positions_);
  for (Block& block : blocks_) block.share = 1.0 / (1.0 + squares(block, positions_) / k_reach);
}

}  // namespace penpose::intent
