#include "core/poses/effect_fit.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/intent/choosing/bounded_squares.h"

namespace penpose::poses {
namespace {

/// A control has to explain this share of what is asked to be used at all.
constexpr double k_least_share = 0.01;
/// Holds controls near rest that do nearly the same: a share of what each does.
constexpr double k_ridge = 1e-3;
constexpr int k_rounds = 5;

/// One direction of one control: from rest to an end of its range, 0 to 1.
struct Half {
  std::size_t control = 0;
  double span = 0;  ///< of the parameter, with its sign
};

std::vector<Half> halves_of(const FaceMeasure& face, const rig::Rig& rig, FacePart part) {
  std::vector<Half> halves;
  const auto parameters = rig.parameters();
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (!face.moves(i, part)) continue;
    const rig::Parameter& one = parameters[i];
    if (one.maximum > one.rest) halves.push_back({i, one.maximum - one.rest});
    if (one.minimum < one.rest) halves.push_back({i, one.minimum - one.rest});
  }
  return halves;
}

class Fit {
 public:
  Fit(const FaceMeasure& face, const rig::Rig& rig, const AskedMoves& asked, std::vector<Half> halves)
      : face_(face), asked_(asked), halves_(std::move(halves)), rest_(rig::rest_pose(rig)) {
    choices_.low.assign(halves_.size(), 0.0);
    choices_.high.assign(halves_.size(), 1.0);
  }

  rig::Pose run() {
    std::vector<double> shares(halves_.size(), 0.0);
    rig::Pose best = rest_;
    double least = left_of(face_, asked_, rest_);
    for (int round = 0; round < k_rounds; ++round) {
      shares = solve(shares);
      const rig::Pose pose = pose_of(shares);
      const double left = left_of(face_, asked_, pose);
      if (left < least - 1e-9) {
        least = left;
        best = pose;
      }
    }
    return best;
  }

 private:
  [[nodiscard]] rig::Pose pose_of(const std::vector<double>& shares) const {
    rig::Pose pose = rest_;
    for (std::size_t i = 0; i < halves_.size(); ++i) pose[halves_[i].control] += shares[i] * halves_[i].span;
    return pose;
  }
  [[nodiscard]] std::vector<double> moves_at(const rig::Pose& pose) const {
    const auto places = face_.places(pose);
    std::vector<double> out;
    for (const std::size_t f : asked_.features) {
      for (std::size_t k = f * k_places; k < (f + 1) * k_places; ++k) {
        const ModelVector by = places[k] - face_.rest()[k];
        out.insert(out.end(), {by.x, by.y, by.z});
      }
    }
    return out;
  }
  /// What each half does alone for one share, along its way to where it is now.
  void measure(const std::vector<double>& shares) {
    columns_.clear();
    for (std::size_t i = 0; i < halves_.size(); ++i) {
      const double share = shares[i] > 0 ? std::max(shares[i], 0.1) : 0.5;
      rig::Pose pose = rest_;
      pose[halves_[i].control] += share * halves_[i].span;
      auto column = moves_at(pose);
      for (double& one : column) one /= share;
      columns_.push_back(std::move(column));
    }
  }
  [[nodiscard]] std::vector<double> solve(const std::vector<double>& shares) {
    measure(shares);
    // What moves do together beyond their sum is taken off what is asked for.
    std::vector<double> wanted = moves_at(pose_of(shares));
    for (std::size_t r = 0; r < wanted.size(); ++r)
      wanted[r] = asked_.moves[r / 3][static_cast<int>(r % 3)] - wanted[r];
    for (std::size_t i = 0; i < halves_.size(); ++i) {
      for (std::size_t r = 0; r < wanted.size(); ++r) wanted[r] += shares[i] * columns_[i][r];
    }
    std::vector<std::size_t> all(halves_.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    // First with a price on each control, which leaves few of them; then these without it.
    const auto priced = squares(wanted, all, k_least_share);
    std::vector<std::size_t> used;
    for (const std::size_t i : all) {
      if (priced[i] > 1e-6) used.push_back(i);
    }
    const auto values = squares(wanted, used, 0);
    std::vector<double> out(halves_.size(), 0.0);
    for (std::size_t k = 0; k < used.size(); ++k) out[used[k]] = values[k];
    return out;
  }
  /// Least squares of some halves, each of which costs `price` of what it could explain of all that is asked for.
  [[nodiscard]] std::vector<double> squares(const std::vector<double>& wanted, const std::vector<std::size_t>& used,
                                            double price) {
    const std::size_t n = used.size();
    std::vector<double> matrix(n * n, 0.0);
    std::vector<double> pulls(n, 0.0);
    const auto product = [](const std::vector<double>& a, const std::vector<double>& b) {
      double sum = 0;
      for (std::size_t r = 0; r < a.size(); ++r) sum += a[r] * b[r];
      return sum;
    };
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; k <= i; ++k)
        matrix[i * n + k] = matrix[k * n + i] = product(columns_[used[i]], columns_[used[k]]);
      pulls[i] = product(columns_[used[i]], wanted) - price * asked_.size() * std::sqrt(matrix[i * n + i]);
    }
    for (std::size_t i = 0; i < n; ++i) matrix[i * n + i] *= 1 + k_ridge;
    return solver_.solve(matrix, pulls, used, choices_);
  }

  const FaceMeasure& face_;
  const AskedMoves& asked_;
  std::vector<Half> halves_;
  rig::Pose rest_;
  intent::Choices choices_;
  intent::BoundedSquares solver_;
  std::vector<std::vector<double>> columns_;
};

}  // namespace

double AskedMoves::size() const {
  double sum = 0;
  for (const ModelVector& move : moves) sum += glm::dot(move, move);
  return std::sqrt(sum);
}

AskedMoves asked_of(const FaceMeasure& face, const std::vector<FeatureMoves>& moves, FacePart part) {
  AskedMoves asked;
  for (std::size_t f = 0; f < face.features().size(); ++f) {
    const MeasuredFeature& feature = face.features()[f];
    if (part != FacePart::all && feature.part != part) continue;
    const auto own =
        std::find_if(moves.begin(), moves.end(), [&](const auto& one) { return one.feature == feature.name; });
    if (own == moves.end()) continue;
    asked.features.push_back(f);
    for (const ModelVector& move : own->moves) asked.moves.push_back(move * feature.unit);
  }
  return asked;
}

double left_of(const FaceMeasure& face, const AskedMoves& asked, const rig::Pose& pose) {
  const double size = asked.size();
  if (!(size > 0)) return 0;
  const auto places = face.places(pose);
  double sum = 0;
  for (std::size_t i = 0; i < asked.features.size(); ++i) {
    for (std::size_t k = 0; k < k_places; ++k) {
      const std::size_t at = asked.features[i] * k_places + k;
      const ModelVector left = asked.moves[i * k_places + k] - (places[at] - face.rest()[at]);
      sum += glm::dot(left, left);
    }
  }
  return std::sqrt(sum) / size;
}

rig::Pose fit_effects(const FaceMeasure& face, const rig::Rig& rig, const AskedMoves& asked, FacePart part) {
  auto halves = halves_of(face, rig, part);
  if (halves.empty() || !(asked.size() > 0)) return rig::rest_pose(rig);
  return Fit(face, rig, asked, std::move(halves)).run();
}

}  // namespace penpose::poses
