#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/head/form.h"
#include "core/mesh/subdivision.h"

namespace penpose::head {

/// The eyeball of the +x side, in centimetres: centre and radius.
inline constexpr std::array<double, 3> k_eye_center{3.0, 0.0, 4.85};
inline constexpr double k_eye_radius = 2.6;
/// Where upper and lower lip meet in the middle of the face, in centimetres.
inline constexpr double k_mouth_y = -6.5;
/// Height of the line between the lips at x, as the cage draws it.
[[nodiscard]] double mouth_line(double x);
/// Height of the plane in which the lips meet, at depth z. It rises to the back and holds the line of sight of a
/// camera, so that a stroke between the lips can be drawn.
[[nodiscard]] constexpr double seam_height(double z) { return k_mouth_y - 0.05 + 0.187 * (9.15 - z); }

/// Where a vertex stands in the loops around eye and mouth; subdivision carries these numbers along, so that later
/// steps can tell a lid from a socket. x: eye loop (-3 behind the eyeball, 0 inner and 1 outer edge of the lid's rim, 2
/// lid, 3 crease, 4 edge of the orbit, 5 elsewhere). y: mouth loop (-2 cavity, 0 where the lips meet, 1 fullest, 2
/// border of the red, 3 around it, 4 muzzle, 5 elsewhere). z: +1 upper lip or lid, -1 lower lip or lid, 0 elsewhere;
/// ears have 3.
using LoopMark = glm::dvec3;

/// What a quad of the cage becomes: how fine, and in which material.
enum class QuadKind : std::uint8_t { skin, coarse_skin, lip, brow, lash, lining, inner_lip };

/// One level of subdivision less is enough.
[[nodiscard]] constexpr bool is_coarse(QuadKind kind) {
  return kind == QuadKind::coarse_skin || kind == QuadKind::lining;
}

/// The control cage of the half with x >= 0. Vertices with x = 0 are on the mirror plane.
struct Cage {
  std::vector<ModelPoint> points;
  std::vector<LoopMark> marks;
  std::vector<mesh::Quad> quads;
  std::vector<QuadKind> kinds;  ///< one a quad

  std::uint32_t add(const ModelPoint& point, const LoopMark& mark = {5, 5, 0});
  void add_quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, QuadKind kind = QuadKind::skin);
  /// Quads between two loops of equal length; `inner` lies inside when `outer` runs counter-clockwise as seen from
  /// outside.
  void add_strip(const std::vector<std::uint32_t>& outer, const std::vector<std::uint32_t>& inner, bool closed,
                 QuadKind kind = QuadKind::skin);
};

/// The whole half: face grid, skull, neck, and the loops of eye, mouth and ear in its holes.
[[nodiscard]] Cage make_cage();

/// Fill the holes of the face grid. `border`: the hole's vertices, counter-clockwise from outside.
/// Eye: 12, starting at the outer corner. Mouth: 11 from the middle of the lower edge to the middle of the upper edge.
/// Ear: 8, starting at the upper front corner.
void add_eye(Cage& cage, const std::vector<std::uint32_t>& border);
void add_mouth(Cage& cage, const std::vector<std::uint32_t>& border);
void add_ear(Cage& cage, const std::vector<std::uint32_t>& border);

}  // namespace penpose::head
