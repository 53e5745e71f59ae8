#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/portrait/face_view.h"

namespace penpose::portrait {

/// How much a proportion of a drawing usually differs.
inline constexpr double k_usual_proportion = 0.09;
/// What a line costs that is a part of a curve, beyond the whole; in units of the energy.
inline constexpr double k_part_cost = 3.0;

/// How a hand draws: in its own proportions, and how steadily.
struct Hand {
  double proportion = k_usual_proportion;  ///< by how much a proportion usually differs from the face at rest
  double width = 1.0;                      ///< how far lines stray, of what is usual
  bool over = false;                       ///< over the face that it sees, a line at a time
};

/// What is known of the face beside a line, when it is asked what that line may be.
struct Belief {
  std::vector<double> shares;       ///< of each control's range; empty: at rest
  std::vector<double> proportions;  ///< of each proportion; empty: none
  double doubt = 1.0;               ///< of pose, proportions and placement: 1 before anything was read
};

/// How likely a line is a stretch of a curve. Where a stretch lies in a drawing is a normal distribution about where it
/// is believed to be; its covariance is the sum of what a hand strays, of where lines begin and end, of what controls
/// do by their usual shares, of proportions, and of the placement. The negative logarithm of that likelihood is the
/// cost of a line.
class Likeness {
 public:
  /// `face` must outlive it. Distributions are made when they are asked for: most stretches are far from any line.
  Likeness(const FaceView& face, Belief belief, const Hand& hand);

  /// Half of the Mahalanobis square and of the logarithm of the determinant, and what a part costs beyond a whole;
  /// infinite from `most` on. `line`: on the face.
  [[nodiscard]] double cost(const Trace& line, std::size_t stretch, double most) const;
  /// Where the stretch is believed to be.
  [[nodiscard]] const Trace& mean(std::size_t stretch) const { return place(stretch).mean; }

 private:
  struct Place {
    Trace mean{};
    PxPoint middle{0, 0};
    std::array<double, 3> near{};  ///< inverse of the covariance of the middle: xx, xy, yy
  };
  struct Normal {
    Spread factor{};  ///< lower Cholesky factor of the covariance, by rows
    double constant = 0;
  };
  [[nodiscard]] const Place& place(std::size_t stretch) const;
  [[nodiscard]] const Normal& normal(std::size_t stretch) const;
  /// Holds how far a stretch moves when the placement changes by its usual doubt.
  [[nodiscard]] std::array<Trace, 4> moves_of(const Stretch& stretch) const;

  const FaceView& face_;
  Belief belief_;
  Hand hand_;
  PxPoint centre_{0, 0};
  // Never change a result.
  mutable std::vector<std::optional<Place>> places_;
  mutable std::vector<std::optional<Normal>> normals_;
};

/// Returns the ways in which a line may slide along a stretch that lies at `mean`: at each end, and in three waves
/// between them, each times its width of doubt.
[[nodiscard]] std::vector<Trace> slides_of(const Trace& mean, const Stretch& stretch);

}  // namespace penpose::portrait
