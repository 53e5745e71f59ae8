#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/document/words/face_marks.h"

namespace penpose::document {

/// Which side of a face something is done on, its own.
enum class FaceSide : std::uint8_t { both, left, right };

/// ", left", ", right"; empty for both.
[[nodiscard]] std::string_view behind(FaceSide side);

/// What is measured of half a face.
enum class Aspect : std::uint8_t {
  brow_in,  ///< towards the middle, negative as all that goes there
  brow_inner_up,
  brow_middle_up,
  brow_outer_up,
  lid_upper_up,
  lid_lower_up,
  lids_out,
  cheek_up,
  cheek_forward,
  hollow_out,
  hollow_up,
  hollow_forward,
  wing_up,
  wing_out,
  corner_out,
  corner_up,
  corner_forward,
  upper_out,
  upper_up,
  upper_middle_up,
  upper_forward,
  upper_red,  ///< how much more of the lip is seen
  lower_out,
  lower_up,
  lower_middle_up,
  lower_forward,
  lower_red,
  chin_up,
  chin_forward,
  gaze_out,
  gaze_up,
  tongue_up,
  tongue_forward,
};
inline constexpr std::size_t k_aspects = 33;

/// How much of each aspect, each by how much an eye sees of it.
using Aspects = std::array<double, k_aspects>;

[[nodiscard]] double product(const Aspects& a, const Aspects& b);
[[nodiscard]] double amount(const Aspects& aspects);
/// Of brows, lids and gaze alone.
[[nodiscard]] double amount_of_eyes(const Aspects& aspects);
/// How much an eye sees of an aspect, 1 for most.
[[nodiscard]] double weight(Aspect aspect);
/// "mouth corner up", "mouth corner down".
[[nodiscard]] std::string_view words_of(Aspect aspect, bool positive, bool both);

/// What one control does to a face at one end of its range.
struct FaceEffect {
  FaceSide side = FaceSide::both;
  Aspects aspects{};                    ///< of that side; of both the mean
  double lid_inner = 0, lid_outer = 0;  ///< how far the halves of the lids go, towards the nose and away from it
  double sideways = 0;                  ///< share of what goes to one side of all that is done, 0..1
  double lips_left = 0;                 ///< shares of the distance between the eyes, to the face's own left
  double chin_left = 0;                 ///< likewise
  double gaze_left = 0;                 ///< likewise
  double left_corner_up = 0;            ///< against the right one
};

[[nodiscard]] FaceEffect effect_of(const FaceMoves& moves);

}  // namespace penpose::document
