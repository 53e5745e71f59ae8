#include "core/intent/earlier_lines.h"

#include <algorithm>

namespace penpose::intent {
namespace {

/// Two lines tell of the same control where it moves both by at least this share of what anything moves each.
constexpr double k_line_tells = 0.45;

/// A drawn curve that stays where it is at a pose.
KnownCurve held_at(const rig::Rig& rig, const rig::Pose& pose, const DrawnCurve& curve) {
  posing::PoseProblem alone;
  alone.pairs.push_back({curve.reference, std::vector<ModelPoint>(curve.reference.size(), ModelPoint{0}), {}});
  alone.start = pose;
  posing::CurveSystem system(rig, alone);
  KnownCurve held{curve.reference, std::vector<ModelPoint>(system.point_count()), 0};
  system.positions(pose, held.target);
  held.doubt = curve.doubt_px * curve.camera.units_per_px(std::max(0.0, curve.camera.depth(held.target.front())));
  return held;
}

/// Takes the lines in question out of what is drawn; they are held where a pose has them.
void hold(const rig::Rig& rig, const rig::Pose& pose, const std::vector<bool>& which, IntentProblem& problem) {
  std::vector<DrawnCurve> drawn;
  for (std::size_t c = 0; c < problem.drawn.size(); ++c) {
    if (!which[c]) {
      drawn.push_back(std::move(problem.drawn[c]));
      continue;
    }
    KnownCurve held = held_at(rig, pose, problem.drawn[c]);
    if (held.doubt > 0.0) problem.kept.push_back(std::move(held));
  }
  problem.drawn = std::move(drawn);
}

/// One row a drawn curve: how far each unit moves it, as a share of what moves it most.
std::vector<std::vector<double>> shares_of_units(const Reader& reader, const std::vector<std::vector<double>>& ways) {
  std::vector<std::vector<double>> shares;
  for (const auto& row : ways) {
    double most = 0;
    for (const double way : row) most = std::max(most, way);
    auto& share = shares.emplace_back();
    for (const Unit& unit : reader.choices().units) {
      double way = 0;
      for (std::size_t m = 0; m < unit.count; ++m) {
        // Pairs of joints are told by their joints.
        if (unit.members[m] < row.size()) way = std::max(way, row[unit.members[m]]);
      }
      share.push_back(most > 0.0 ? way / most : 0.0);
    }
  }
  return shares;
}

}  // namespace

IntentProblem with_earlier_constrained(const rig::Rig& rig, const IntentProblem& problem) {
  IntentProblem held = problem;
  if (problem.posed.empty()) return held;
  held.start = problem.posed;
  held.posed.clear();
  std::vector<bool> which;
  for (const DrawnCurve& curve : problem.drawn) which.push_back(curve.before);
  hold(rig, problem.posed, which, held);
  return held;
}

IntentProblem without_earlier(const IntentProblem& problem) {
  IntentProblem alone = problem;
  alone.start = problem.posed;
  alone.posed.clear();
  std::erase_if(alone.drawn, [](const DrawnCurve& curve) { return curve.before; });
  return alone;
}

IntentProblem with_unrelated_constrained(const rig::Rig& rig, const Reader& reader, const IntentProblem& problem) {
  const auto ways = reader.curve_displacements();
  const auto shares = shares_of_units(reader, ways);
  const std::size_t drawn = problem.drawn.size();
  const auto tell_the_same = [&](std::size_t a, std::size_t b) {
    for (std::size_t u = 0; u < shares[a].size(); ++u) {
      if (std::min(shares[a][u], shares[b][u]) >= k_line_tells) return true;
    }
    return false;
  };
  std::vector<bool> others(drawn, false);
  for (std::size_t c = 0; c < drawn; ++c) {
    others[c] = problem.drawn[c].before;
    for (std::size_t now = 0; now < drawn && others[c]; ++now) {
      if (!problem.drawn[now].before && tell_the_same(c, now)) others[c] = false;
    }
  }
  IntentProblem part = problem;
  // What moved belongs to the line that it moves farthest.
  for (std::size_t i = 0; i < part.start.size(); ++i) {
    if (problem.posed[i] == problem.start[i]) continue;
    const auto at = std::lower_bound(reader.parameters().begin(), reader.parameters().end(), i);
    bool anew = false;
    if (at != reader.parameters().end() && *at == i) {
      const auto variable = static_cast<std::size_t>(at - reader.parameters().begin());
      std::size_t most = 0;
      for (std::size_t c = 1; c < drawn; ++c) {
        if (ways[c][variable] > ways[most][variable]) most = c;
      }
      anew = !others[most];
    }
    if (!anew) part.start[i] = problem.posed[i];
  }
  hold(rig, problem.posed, others, part);
  return part;
}

Fit fit_of(const rig::Rig& rig, const WholeModel& whole, const IntentProblem& problem, const rig::Pose& pose,
           const Fit* as) {
  Reader reader = Reader::of(rig, whole, problem);
  const Choice choice = reader.choice_of(pose);
  const ReadingCosts reading = reader.reading_costs();
  const double costs = reading.costs_of(choice) + reading.limit_costs(choice);
  const auto is_set = [&](std::size_t c) { return as != nullptr && problem.drawn[c].before; };
  for (std::size_t c = 0; c < problem.drawn.size(); ++c) {
    if (is_set(c)) reader.align(c, as->aligned[c]);
  }
  Fit fit{costs + reader.energy_at(pose), {}, {}};
  for (std::size_t c = 0; c < problem.drawn.size(); ++c) {
    if (is_set(c)) continue;
    std::size_t chosen = 0;
    for (std::size_t a = 1; a < reader.alignments(c).size(); ++a) {
      reader.align(c, a);
      const double one = costs + reader.energy_at(pose);
      if (!(one < fit.energy - 1e-9)) continue;
      fit.energy = one;
      chosen = a;
    }
    reader.align(c, chosen);
  }
  reader.energy_at(pose);
  for (std::size_t c = 0; c < problem.drawn.size(); ++c) {
    fit.squares.push_back(reader.squares_at(c, pose));
    fit.aligned.push_back(reader.aligned(c));
  }
  return fit;
}

}  // namespace penpose::intent
