#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "core/geometry/camera.h"
#include "ui/render/ghosts/ghost_faces.h"
#include "ui/render/scene.h"

namespace penpose::render {

/// The tints of what comes before a moment and of what comes after it; sRGB. Unlike skin, and unlike what is drawn.
inline constexpr std::uint32_t k_before_color = 0xc04bff;
inline constexpr std::uint32_t k_after_color = 0x19c8d8;

/// The tint of a ghost; its alpha is less the farther away it is.
[[nodiscard]] Color ghost_color(const GhostMoment& moment);

/// A line of a ghost, by its place in the lists.
struct GhostPlace {
  std::size_t ghost = 0;
  std::size_t line = 0;
  friend bool operator==(const GhostPlace&, const GhostPlace&) = default;
};

struct GhostInk {
  float scale = 1;                     ///< px of the display for each px of an ordinary one
  std::optional<GhostPlace> lit = {};  ///< this one stands out, and the others step back
};

/// The places of ghosts in their list, the farthest moments first.
[[nodiscard]] std::vector<std::size_t> farthest_first(std::span<const Ghost> ghosts);

/// From nothing where a place of a ghost lies where the face is now, to 1 a few px away. `px`: how far it is away.
[[nodiscard]] float ghost_apart(double px, float scale);

/// The lines of ghosts, the farthest first. What lies where the face is now (`now`: all vertices) is left out.
[[nodiscard]] std::vector<CurveDrawing> ghost_drawings(std::span<const Ghost> ghosts, std::span<const glm::vec3> now,
                                                       const geometry::Camera& camera, const GhostInk& ink);

/// The line of a feature, or of a drawn curve, that is nearest to a place of the view; of two ghosts whose lines lie
/// together, that of the nearer moment. Nothing: none is within that distance.
[[nodiscard]] std::optional<GhostPlace> ghost_near(std::span<const Ghost> ghosts, geometry::PxPoint at,
                                                   double within_px);

}  // namespace penpose::render
