#include "core/articulation/motion/curve_skin.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/articulation/motion/slide.h"
#include "core/base/sine_cosine.h"

namespace penpose::articulation {
namespace {

ModelVector mix(const ModelVector& a, const ModelVector& b, double t) { return a * (1.0 - t) + b * t; }

template <typename T>
std::vector<T> chosen(const std::vector<T>& all, std::span<const std::uint32_t> places) {
  std::vector<T> some;
  if (all.empty()) return some;
  some.reserve(places.size());
  for (const std::uint32_t place : places) some.push_back(all[place]);
  return some;
}

}  // namespace

CurveSkin::CurveSkin(std::shared_ptr<const CurveMotion> motion, KeptSurface surface,
                     std::span<const ClosestBinding> bindings, bool carried)
    : motion_(std::move(motion)), surface_(std::move(surface)) {
  const auto reference = motion_->reference();
  const auto target = motion_->target();
  reserve(bindings.size(), carried);
  for (const ClosestBinding& binding : bindings) {
    const std::uint32_t k = binding.segment;
    rests_.push_back(binding.rest);
    if (surface_.exists()) levels_.push_back(surface_.level(binding.rest));
    if (carried) to_rest_.push_back(binding.to_rest);
    if (!turning()) {
      const ModelVector move = mix(target[k] - reference[k], target[k + 1] - reference[k + 1], binding.fraction);
      const ModelVector column = move * binding.weight;
      columns_.push_back(carried && linear() ? binding.to_rest * column : column);
      continue;
    }
    const ModelVector axis = motion_->axis(k);
    const ModelVector offset = binding.rest - mix(reference[k], reference[k + 1], binding.fraction);
    const ModelVector along = axis * glm::dot(axis, offset);
    segments_.push_back(k);
    fractions_.push_back(binding.fraction);
    weights_.push_back(binding.weight);
    turns_.push_back(binding.fraction * motion_->angle(k));
    offsets_.push_back({along, offset - along, glm::cross(axis, offset)});
  }
  mark_segments();
}

CurveSkin::CurveSkin(std::shared_ptr<const CurveMotion> motion, KeptSurface surface,
                     std::span<const BlendedBinding> bindings, bool carried)
    : motion_(std::move(motion)), surface_(std::move(surface)) {
  const auto reference = motion_->reference();
  reserve(bindings.size(), carried);
  const bool slides = motion_->slide() != nullptr;
  for (const BlendedBinding& one : bindings) {
    if (one.more == ModelVector{0} && one.less == ModelVector{0}) continue;
    for (const BlendedBinding& each : bindings) {
      mores_.push_back(each.more);
      lesses_.push_back(each.less);
    }
    break;
  }
  for (const BlendedBinding& binding : bindings) {
    rests_.push_back(binding.rest);
    if (surface_.exists()) levels_.push_back(surface_.level(binding.rest));
    if (carried) to_rest_.push_back(binding.to_rest);
    if (slides) slides_.push_back(binding.turn);
    if (!turning()) {
      columns_.push_back(carried && linear() ? binding.to_rest * binding.move : binding.move);
      continue;
    }
    const std::uint32_t k = binding.segment;
    const ModelPoint about = mix(reference[k], reference[k + 1], binding.fraction);
    const ModelVector offset = binding.rest - about;
    const ModelVector axis = geometry::normalized(binding.turn);
    const ModelVector along = axis * glm::dot(axis, offset);
    segments_.push_back(k);
    fractions_.push_back(binding.fraction);
    weights_.push_back(binding.weight);
    turns_.push_back(geometry::length(binding.turn));
    offsets_.push_back({along, offset - along, glm::cross(axis, offset)});
    bases_.push_back(about * binding.weight + offset - along);
  }
}

/// No more than is used: edits of deformers keep many of them for undo.
void CurveSkin::reserve(std::size_t count, bool carried) {
  rests_.reserve(count);
  if (surface_.exists()) levels_.reserve(count);
  if (carried) to_rest_.reserve(count);
  if (!turning()) return columns_.reserve(count);
  segments_.reserve(count);
  fractions_.reserve(count);
  weights_.reserve(count);
  turns_.reserve(count);
  offsets_.reserve(count);
  if (motion_->swing() != nullptr) bases_.reserve(count);
}

void CurveSkin::mark_segments() {
  for (const std::uint32_t k : segments_) {
    if (k >= wanted_.size()) wanted_.resize(k + 1, 0);
    wanted_[k] = 1;
  }
}

CurveSkin CurveSkin::subset(std::span<const std::uint32_t> places) const {
  CurveSkin some;
  some.motion_ = motion_;
  some.surface_ = surface_;
  const auto choose = [&](auto... lists) { ((some.*lists = chosen(this->*lists, places)), ...); };
  choose(&CurveSkin::rests_, &CurveSkin::levels_, &CurveSkin::columns_, &CurveSkin::segments_, &CurveSkin::fractions_,
         &CurveSkin::weights_, &CurveSkin::turns_, &CurveSkin::offsets_, &CurveSkin::to_rest_, &CurveSkin::bases_,
         &CurveSkin::mores_, &CurveSkin::lesses_, &CurveSkin::slides_);
  for (const BetweenKnot& one : betweens_) some.betweens_.push_back({one.knot, chosen(one.differences, places)});
  if (some.bases_.empty()) some.mark_segments();
  return some;
}

namespace {

/// Sines and cosines of the vertices' own turns.
void turn_vertices(double amount, std::span<const double> turns, CurveSkinWorkspace& work) {
  work.angles.resize(turns.size());
  work.sines.resize(turns.size());
  work.cosines.resize(turns.size());
  for (std::size_t i = 0; i < turns.size(); ++i) work.angles[i] = amount * turns[i];
  base::sine_cosine(work.angles, work.sines, work.cosines);
}

}  // namespace

void CurveSkin::turned(double amount, CurveSkinWorkspace& work, std::span<ModelVector> out) const {
  motion_->frames(amount, wanted_, work.motion);
  const std::size_t n = rests_.size();
  turn_vertices(amount, turns_, work);
  for (std::size_t i = 0; i < n; ++i) {
    const SegmentFrame& frame = work.motion.frames[segments_[i]];
    const Offset& offset = offsets_[i];
    const ModelVector local =
        offset.along + offset.level * work.cosines[i] + offset.ahead * work.sines[i] + frame.step * fractions_[i];
    out[i] = (frame.turn * local + (frame.start - rests_[i])) * weights_[i];
  }
}

void CurveSkin::swung(double amount, CurveSkinWorkspace& work, std::span<ModelVector> out) const {
  std::vector<ModelPoint>& points = work.motion.points;
  points.resize(motion_->reference().size());
  motion_->swing()->points(amount, work.motion.swing, points);
  const std::size_t n = rests_.size();
  turn_vertices(amount, turns_, work);
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t k = segments_[i];
    const Offset& offset = offsets_[i];
    out[i] = mix(points[k], points[k + 1], fractions_[i]) * weights_[i] - bases_[i] + offset.level * work.cosines[i] +
             offset.ahead * work.sines[i];
  }
}

void CurveSkin::add_more(double amount, std::span<ModelVector> out) const {
  const std::vector<ModelVector>& more = amount < 0.0 ? lesses_ : mores_;
  for (std::size_t i = 0; i < more.size(); ++i) out[i] += more[i] * amount;
}

void CurveSkin::slid(double amount, std::span<ModelVector> out) const {
  const ModelPoint& center = motion_->slide()->center();
  for (std::size_t i = 0; i < rests_.size(); ++i) {
    const ModelVector from = rests_[i] - center;
    out[i] = turned_by(columns_[i] * amount, turned_by(slides_[i] * amount, from)) - from;
  }
}

void CurveSkin::displacements(double amount, CurveSkinWorkspace& work, std::span<ModelVector> out) const {
  if (amount == 0.0) {
    std::fill(out.begin(), out.end(), ModelVector{0});
    return;
  }
  moved(amount, work, out);
  bool between_targets = false;
  for (const BetweenKnot& between : betweens_) {
    const double weight = between.knot.weight(amount);
    if (weight == 0.0) continue;
    between_targets = true;
    for (std::size_t i = 0; i < out.size(); ++i) out[i] += between.differences[i] * weight;
  }
  if (between_targets) hold(out);
}

/// Between two targets the straight way would cut through the surface.
void CurveSkin::hold(std::span<ModelVector> out) const {
  if (!surface_.exists()) return;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const ModelVector move = to_rest_.empty() ? out[i] : glm::inverse(to_rest_[i]) * out[i];
    const ModelVector held = surface_.keep(rests_[i] + move, rests_[i], levels_[i]) - rests_[i];
    out[i] = to_rest_.empty() ? held : to_rest_[i] * held;
  }
}

void CurveSkin::add_betweens(std::vector<BetweenDisplacements> betweens) {
  std::vector<double> amounts;
  for (const BetweenDisplacements& one : betweens) amounts.push_back(one.amount);
  const std::vector<Knot> knots = knots_of(amounts);
  CurveSkinWorkspace work;
  std::vector<ModelVector> before(size());
  std::vector<BetweenKnot> added;
  for (std::size_t i = 0; i < betweens.size(); ++i) {
    displacements(amounts[i], work, before);
    BetweenKnot one{knots[i], std::move(betweens[i].moves)};
    for (std::size_t k = 0; k < before.size(); ++k) one.differences[k] -= before[k];
    added.push_back(std::move(one));
  }
  betweens_ = std::move(added);
}

void CurveSkin::moved(double amount, CurveSkinWorkspace& work, std::span<ModelVector> out) const {
  if (!bases_.empty()) {
    swung(amount, work, out);
  } else if (turning()) {
    turned(amount, work, out);
  } else if (!slides_.empty()) {
    slid(amount, out);
  } else {
    for (std::size_t i = 0; i < rests_.size(); ++i) out[i] = columns_[i] * amount;
    if (!surface_.exists() && mores_.empty()) return;
  }
  add_more(amount, out);
  if (surface_.exists()) {
    for (std::size_t i = 0; i < rests_.size(); ++i) {
      out[i] = surface_.keep(rests_[i] + out[i], rests_[i], levels_[i]) - rests_[i];
    }
  }
  for (std::size_t i = 0; i < to_rest_.size(); ++i) out[i] = to_rest_[i] * out[i];
}

}  // namespace penpose::articulation
