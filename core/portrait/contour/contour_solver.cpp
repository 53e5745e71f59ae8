#include "core/portrait/contour/contour_solver.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/algebra/cholesky.h"
#include "core/base/math.h"

namespace penpose::portrait {
namespace {

constexpr std::size_t k_sheet = SheetPlace::k_widths.size();
/// Rounds of the sheet alone, of guesses, and of the reading that is taken.
constexpr int k_sheet_rounds = 8, k_guess_rounds = 4, k_chosen_rounds = 2, k_last_rounds = 8;
/// Guesses that are refined, each of another unit, steps by one unit, and units at most.
constexpr std::size_t k_guesses = 5;
constexpr int k_contour_steps = 6;
constexpr std::size_t k_most_contour_units = 6;
/// A turn changes by at most so much in one round, half circles; a share of a range by so much.
constexpr double k_trust = 0.15, k_gain = 1e-6;
/// What stays where other lines put it is held like this many looks, each point.
constexpr double k_kept_looks = 4.0;
/// Points nearer to their contour than this may be there; those that are near none count as so far away.
constexpr double k_near_px = 4.0, k_far_px = 60.0;
/// Differences by which columns are made.
constexpr double k_difference = 1e-4;

}  // namespace

PxPoint SheetPlace::operator()(const PxPoint& p) const { return placement()(p); }

Placement SheetPlace::placement() const {
  const double grown = 1.0 + moved_[2] * widths_[2];
  const double turn = moved_[3] * widths_[3];
  const double along = grown * base::cos(turn);
  const double across = grown * base::sin(turn);
  Placement out;
  out.along = along * first_.along - across * first_.across;
  out.across = along * first_.across + across * first_.along;
  const PxPoint from = first_.shift - middle_;
  out.shift = middle_ + PxPoint{along * from.x - across * from.y, along * from.y + across * from.x} +
              PxPoint{moved_[0] * widths_[0], moved_[1] * widths_[1]};
  return out;
}

std::array<PxPoint, 4> SheetPlace::ways(const PxPoint& at) const {
  const PxPoint from = at - middle_;
  return {PxPoint{widths_[0], 0}, PxPoint{0, widths_[1]}, from * widths_[2], PxPoint{-from.y, from.x} * widths_[3]};
}

void SheetPlace::move(std::span<const double> by) {
  for (std::size_t k = 0; k < k_sheet; ++k) moved_[k] += by[k];
}

double SheetPlace::squares() const {
  double sum = 0;
  for (const double m : moved_) sum += m * m;
  return sum;
}

ContourSolver::ContourSolver(const rig::Rig& rig, const ContourControls& controls, SeenContours& contours,
                             std::span<const EvenLine> lines, std::span<const posing::CurvePoint> kept,
                             const rig::Pose& start)
    : rig_(rig), controls_(controls), contours_(contours), lines_(lines), kept_(kept) {
  costs_.unit = 6;
  costs_.evidence = 0;
  costs_.movement = 2.5;
  quadratic_.reset(controls.variable_count(), 0, 0);
  quadratic_.finish();
  std::vector<geometry::ModelPoint> places(rig.vertex_count());
  rig.evaluate(start, places);
  for (const posing::CurvePoint& point : kept)
    kept_px_.push_back(contours.camera().project(place_of(point, places)).value_or(PxPoint{}));
}

double ContourSolver::costs_of(const intent::Choice& choice) {
  const intent::Selection selection(quadratic_, controls_.choices(), costs_);
  double sum = selection.costs_of(choice) + selection.limit_costs(choice) + controls_.lean_costs(choice);
  for (std::size_t i = 0; i < choice.variables.size(); ++i)
    sum += controls_.choices().stiffness[choice.variables[i]] * choice.values[i] * choice.values[i];
  return sum;
}

void ContourSolver::measure(ContourReading& reading) {
  const rig::Pose pose = controls_.pose_of(reading.choice);
  contours_.look(pose);
  reading.energy = reading.sheet.squares() + costs_of(reading.choice);
  reading.matches.clear();
  for (const EvenLine& line : lines_) {
    EvenLine placed = line;
    for (PxPoint& p : placed.points) p = reading.sheet(p);
    placed.spacing = line.spacing * reading.sheet.placement().scale();
    reading.matches.push_back(match_contour(placed, contours_.lines()));
    reading.energy += reading.matches.back().doubt;
  }
  if (kept_.empty()) return;
  const auto places = contours_.positions();
  for (std::size_t i = 0; i < kept_.size(); ++i) {
    const PxPoint at = contours_.camera().project(place_of(kept_[i], places)).value_or(kept_px_[i]);
    reading.energy += k_kept_looks * contour_doubt(geometry::distance(at, kept_px_[i]));
  }
}

void ContourSolver::add_rows(const ContourReading& reading) {
  rows_.clear();
  for (std::size_t l = 0; l < lines_.size(); ++l) {
    const double spacing = lines_[l].spacing * reading.sheet.placement().scale();
    for (std::size_t i = 0; i < lines_[l].points.size(); ++i) {
      const auto& place = reading.matches[l].places[i];
      if (!place) continue;
      const SeenContour& contour = contours_.lines()[place->line];
      const PxPoint target = reading.sheet(lines_[l].points[i]);
      const double weight = contour_weight(geometry::distance(target, place->px));
      const double factor = std::sqrt(spacing / k_contour_look_px * weight) / k_contour_doubt_px;
      Row row;
      row.point = point_between(contour.points[place->segment], contour.points[place->segment + 1], place->share);
      row.way = place->normal * factor;
      row.right = geometry::dot(row.way, target - place->px);
      const auto ways = reading.sheet.ways(target);
      for (std::size_t k = 0; k < k_sheet; ++k) row.sheet[k] = -geometry::dot(row.way, ways[k]);
      rows_.push_back(row);
    }
  }
  const auto places = contours_.positions();
  for (std::size_t i = 0; i < kept_.size(); ++i) {
    const PxPoint at = contours_.camera().project(place_of(kept_[i], places)).value_or(kept_px_[i]);
    const double weight = contour_weight(geometry::distance(at, kept_px_[i]));
    const double factor = std::sqrt(k_kept_looks * weight) / k_contour_doubt_px;
    for (const PxPoint way : {PxPoint{factor, 0}, PxPoint{0, factor}}) {
      Row row;
      row.point = kept_[i];
      row.way = way;
      row.right = geometry::dot(way, kept_px_[i] - at);
      rows_.push_back(row);
    }
  }
}

void ContourSolver::slide(std::span<double> column) const {
  double* const slid = column.data() + rows_.size();
  for (std::size_t k = 0; k < k_sheet; ++k) {
    double sum = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i) sum += rows_[i].sheet[k] * column[i];
    slid[k] = sum;
  }
}

void ContourSolver::fill_columns(const ContourReading& reading, std::span<const std::size_t> variables) {
  std::vector<std::uint32_t> vertices;
  for (const Row& row : rows_) vertices.insert(vertices.end(), row.point.vertex.begin(), row.point.vertex.end());
  const auto bound = rig_.bind(vertices);
  std::vector<geometry::ModelPoint> here(vertices.size()), there(vertices.size());
  bound->evaluate(controls_.pose_of(reading.choice), here);
  const auto place = [&](const std::vector<geometry::ModelPoint>& places, std::size_t i) {
    geometry::ModelPoint sum(0);
    for (std::size_t k = 0; k < 3; ++k) sum += places[3 * i + k] * rows_[i].point.weight[k];
    return contours_.camera().project(sum).value_or(PxPoint{});
  };
  std::vector<PxPoint> from;
  for (std::size_t i = 0; i < rows_.size(); ++i) from.push_back(place(here, i));
  const intent::Choices& choices = controls_.choices();
  for (const std::size_t v : variables) {
    const auto at = std::lower_bound(reading.choice.variables.begin(), reading.choice.variables.end(), v);
    const bool moves = at != reading.choice.variables.end() && *at == v;
    const double value =
        moves ? reading.choice.values[static_cast<std::size_t>(at - reading.choice.variables.begin())] : 0.0;
    const double step = value + k_difference <= choices.high[v] ? k_difference : -k_difference;
    bound->evaluate(controls_.pose_beside(reading.choice, v, step), there);
    const auto column = quadratic_.column(v);
    for (std::size_t i = 0; i < rows_.size(); ++i)
      column[i] = geometry::dot(rows_[i].way, place(there, i) - from[i]) / step;
    const auto right = quadratic_.right();
    if (value != 0.0) {
      for (std::size_t i = 0; i < rows_.size(); ++i) right[i] += column[i] * value;
    }
  }
}

void ContourSolver::look(const ContourReading& reading, std::span<const std::size_t> variables) {
  add_rows(reading);
  sheet_factor_.fill(0.0);
  for (std::size_t k = 0; k < k_sheet; ++k) {
    for (std::size_t l = 0; l <= k; ++l) {
      double sum = k == l ? 1.0 : 0.0;
      for (const Row& row : rows_) sum += row.sheet[k] * row.sheet[l];
      sheet_factor_[k * k_sheet + l] = sheet_factor_[l * k_sheet + k] = sum;
    }
  }
  static_cast<void>(algebra::factor(sheet_factor_.data(), k_sheet));
  quadratic_.reset(controls_.variable_count(), rows_.size(), k_sheet);
  const auto right = quadratic_.right();
  for (std::size_t i = 0; i < rows_.size(); ++i) right[i] = rows_[i].right;
  fill_columns(reading, variables);
  for (const std::size_t v : variables) {
    slide(quadratic_.column(v));
    algebra::solve_forward(sheet_factor_.data(), k_sheet, quadratic_.column(v).data() + rows_.size());
  }
  slide(right);
  for (std::size_t k = 0; k < k_sheet; ++k) right[rows_.size() + k] -= reading.sheet.moved()[k];
  algebra::solve_forward(sheet_factor_.data(), k_sheet, right.data() + rows_.size());
  quadratic_.finish(variables);
}

void ContourSolver::settle_sheet(ContourReading& reading) const {
  std::vector<double> left(rows_.size() + k_sheet, 0.0);
  for (std::size_t i = 0; i < rows_.size(); ++i) left[i] = quadratic_.right()[i];
  for (std::size_t j = 0; j < reading.choice.variables.size(); ++j) {
    const auto column = quadratic_.column(reading.choice.variables[j]);
    for (std::size_t i = 0; i < rows_.size(); ++i) left[i] -= column[i] * reading.choice.values[j];
  }
  slide(left);
  const std::span by = std::span(left).last(k_sheet);
  for (std::size_t k = 0; k < k_sheet; ++k) by[k] -= reading.sheet.moved()[k];
  algebra::solve_factored(sheet_factor_.data(), k_sheet, by.data());
  reading.sheet.move(by);
}

ContourReading ContourSolver::still(const SheetPlace& sheet) {
  ContourReading reading;
  reading.sheet = sheet;
  return refined(reading, k_sheet_rounds);
}

ContourReading ContourSolver::refined(ContourReading reading, int rounds) {
  measure(reading);
  ContourReading best = reading;
  for (int round = 0; round < rounds; ++round) {
    look(reading, reading.choice.variables);
    if (!reading.choice.units.empty()) {
      intent::Selection selection(quadratic_, controls_.choices(), costs_);
      reading.choice = intent::trusted(reading.choice, selection.fit(reading.choice.units), k_trust,
                                       [](std::size_t) { return true; });
    }
    settle_sheet(reading);
    measure(reading);
    if (reading.energy < best.energy) best = reading;
  }
  return best;
}

ContourReading ContourSolver::chosen(ContourReading reading, int rounds) {
  std::vector<std::size_t> all(controls_.variable_count());
  for (std::size_t v = 0; v < all.size(); ++v) all[v] = v;
  measure(reading);
  ContourReading best = reading;
  for (int round = 0; round < rounds; ++round) {
    look(reading, all);
    intent::Selection selection(quadratic_, controls_.choices(), costs_);
    reading.choice =
        intent::trusted(reading.choice, selection.select(selection.fit(reading.choice.units), k_most_contour_units),
                        k_trust, [](std::size_t) { return true; });
    settle_sheet(reading);
    measure(reading);
    if (reading.energy < best.energy) best = reading;
  }
  return best;
}

std::vector<ContourReading> ContourSolver::explored(const ContourReading& from) {
  const intent::Choices& choices = controls_.choices();
  std::vector<ContourReading> best;
  for (std::size_t u = 0; u < choices.units.size(); ++u) {
    const auto& unit = choices.units[u];
    const bool moves = std::binary_search(from.choice.units.begin(), from.choice.units.end(), u);
    if (!moves && from.choice.units.size() >= k_most_contour_units) continue;
    const bool other = std::any_of(unit.members.begin(), unit.members.begin() + unit.count, [&](std::size_t v) {
      return std::binary_search(from.choice.variables.begin(), from.choice.variables.end(), v);
    });
    if (other && !moves) continue;
    std::vector<std::size_t> units = from.choice.units;
    if (!moves) units.insert(std::lower_bound(units.begin(), units.end(), u), u);
    std::optional<ContourReading> of_unit;
    for (const std::vector<double>& guess : controls_.guesses(u)) {
      ContourReading one;
      one.sheet = from.sheet;
      one.choice = intent::choice_of_units(choices, units);
      one.choice.values.assign(one.choice.variables.size(), 0.0);
      for (std::size_t i = 0; i < one.choice.variables.size(); ++i) {
        const std::size_t v = one.choice.variables[i];
        const auto member = std::find(unit.members.begin(), unit.members.begin() + unit.count, v);
        const auto before = std::lower_bound(from.choice.variables.begin(), from.choice.variables.end(), v);
        if (member != unit.members.begin() + unit.count) {
          one.choice.values[i] = std::clamp(guess[static_cast<std::size_t>(member - unit.members.begin())],
                                            choices.low[v], choices.high[v]);
        } else if (before != from.choice.variables.end() && *before == v) {
          one.choice.values[i] = from.choice.values[static_cast<std::size_t>(before - from.choice.variables.begin())];
        }
      }
      measure(one);
      if (!of_unit || one.energy < of_unit->energy) of_unit = std::move(one);
    }
    if (!of_unit) continue;
    const auto at = std::upper_bound(best.begin(), best.end(), of_unit->energy,
                                     [](double energy, const ContourReading& b) { return energy < b.energy; });
    best.insert(at, std::move(*of_unit));
    if (best.size() > k_guesses) best.pop_back();
  }
  return best;
}

ContourReading ContourSolver::pruned(ContourReading reading) {
  for (std::size_t i = 0; i < reading.choice.units.size();) {
    std::vector<std::size_t> units = reading.choice.units;
    units.erase(units.begin() + static_cast<std::ptrdiff_t>(i));
    ContourReading less;
    less.sheet = reading.sheet;
    less.choice = intent::choice_of_units(controls_.choices(), units);
    for (const std::size_t v : less.choice.variables) {
      const auto at = std::lower_bound(reading.choice.variables.begin(), reading.choice.variables.end(), v);
      less.choice.values.push_back(
          reading.choice.values[static_cast<std::size_t>(at - reading.choice.variables.begin())]);
    }
    less = refined(less, k_guess_rounds);
    if (less.energy < reading.energy) {
      reading = std::move(less);
      i = 0;
    } else {
      ++i;
    }
  }
  return reading;
}

double ContourSolver::standing_out(const ContourReading& reading) const {
  double sum = 0;
  for (std::size_t l = 0; l < lines_.size(); ++l) {
    const double looks = lines_[l].spacing * reading.sheet.placement().scale() / k_contour_look_px;
    for (std::size_t i = 0; i < lines_[l].points.size(); ++i) {
      const auto& place = reading.matches[l].places[i];
      const double px = place ? geometry::distance(reading.sheet(lines_[l].points[i]), place->px) : k_far_px;
      sum += looks * std::max(0.0, contour_doubt(px) - contour_doubt(k_near_px));
    }
  }
  return sum;
}

ContourReading ContourSolver::solve(const ContourReading& still) {
  ContourReading best = still;
  for (int step = 0; step < k_contour_steps && standing_out(best) > costs_.unit; ++step) {
    ContourReading next = chosen(best, k_guess_rounds);
    for (const ContourReading& guess : explored(best)) {
      ContourReading one = refined(guess, k_guess_rounds);
      if (one.energy < next.energy) next = std::move(one);
    }
    ContourReading more = chosen(next, k_chosen_rounds);
    if (more.energy < next.energy) next = std::move(more);
    if (!(next.energy < best.energy - k_gain)) break;
    best = std::move(next);
  }
  return refined(pruned(best), k_last_rounds);
}

}  // namespace penpose::portrait
