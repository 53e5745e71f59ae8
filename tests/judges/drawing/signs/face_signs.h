#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "tests/judges/drawing/curve_places.h"

namespace penpose::judges::drawn {

/// The character's own side; its left is at the right of a picture from the front.
enum class Side : unsigned char { left, right };

/// What a person sees of an expression, against the face at rest. Unless a side is named, the mean of both.
enum class Sign : unsigned char {
  corner,  ///< corners of the mouth above the middle of the lips, mouth widths; less what a dropped jaw leaves behind
  corner_left,
  corner_right,
  corner_skew,  ///< by how much the corner of the side that is meant is higher; of no side: the greater of both
  gap,          ///< between the lips, mouth widths
  width,        ///< of the mouth, mouth widths
  brow_in,      ///< inner third of the brows, face heights
  brow_in_left,
  brow_in_right,
  brow_out,   ///< outer third
  brow_tilt,  ///< brow_in - brow_out
  lid,        ///< opening of the eyes, as a share of that at rest
  lid_left,
  lid_right,
  lid_least,
  lid_skew,
  lid_this,   ///< of the side that is meant; of no side: the lesser
  lid_other,  ///< the other one
  sneer,      ///< wings of the nose or the upper lip raised, face heights
};
inline constexpr std::size_t k_sign_count = static_cast<std::size_t>(Sign::sneer) + 1;

/// One value a sign.
struct Signs {
  std::array<double, k_sign_count> values{};
  [[nodiscard]] double operator[](Sign sign) const { return values[static_cast<std::size_t>(sign)]; }
  double& operator[](Sign sign) { return values[static_cast<std::size_t>(sign)]; }
};

/// Measures the signs of an expression on the feature curves of a face, by the names that maps use. A face without
/// brows or lids shows no signs of them.
class FaceSigns {
 public:
  /// `rest`: where the curves are at rest. Errors (place: the curve): the face has no outer border of a lip.
  static base::Result<FaceSigns> make(std::span<const portrait::FeatureCurve> curves, const CurvePlaces& rest,
                                      double front_yaw_degrees);

  /// Precondition: `places` are of the curves that this was made of, with any turn of the head taken out.
  [[nodiscard]] Signs of(const CurvePlaces& places, std::optional<Side> meant) const;
  /// How far lips or lids run through one another, model units; 0 where they do not.
  [[nodiscard]] double crossing(const CurvePlaces& places) const;
  /// From the hairline to the chin, model units.
  [[nodiscard]] double height() const { return height_; }
  /// The points that an expression leaves where they are: corners of the eyes and the nose.
  struct Point {
    std::size_t curve = 0, index = 0;
  };
  [[nodiscard]] std::span<const Point> fixed() const { return fixed_; }

 private:
  using Flat = std::vector<std::vector<geometry::PxPoint>>;  ///< x to the right of a picture from the front, y up
  /// Points of one curve; none where the face has no such curve.
  struct Some {
    std::size_t curve = 0;
    std::vector<std::size_t> points;
    [[nodiscard]] bool any() const { return !points.empty(); }
  };
  /// Numbers that signs compare with those at rest. Of two: left, right.
  struct Numbers {
    std::array<double, 2> corner{}, brow_in{}, brow_out{}, lid{};
    double gap = 0, width = 0, lip = 0;
    std::vector<double> wings;
  };

  FaceSigns() = default;
  void find_lips(std::span<const portrait::FeatureCurve> curves, const Flat& rest);
  void find_brows(std::span<const portrait::FeatureCurve> curves, const Flat& rest);
  void find_lids(std::span<const portrait::FeatureCurve> curves, const Flat& rest);
  void find_fixed(std::span<const portrait::FeatureCurve> curves, const Flat& rest);
  [[nodiscard]] Flat flat(const CurvePlaces& places) const;
  [[nodiscard]] Numbers numbers(const Flat& lines) const;

  geometry::PxPoint right_{1, 0};  ///< x and z of the picture's way to the right
  std::array<Point, 2> corners_{};
  Some upper_, lower_, upper_inner_, lower_inner_, wings_;
  std::array<Some, 2> brow_in_, brow_out_, lid_upper_, lid_lower_;
  std::array<double, 2> open_{1, 1};  ///< what eyes are open by at rest
  std::vector<Point> fixed_;
  Numbers rest_;
  double height_ = 1, mouth_ = 1;
};

}  // namespace penpose::judges::drawn
