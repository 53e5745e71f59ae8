#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/portrait/surface/face_surface.h"

namespace penpose::portrait {

/// A place of the skin that is seen in the picture.
struct SurfacePlace {
  mesh::MeshPoint point;
  ModelPoint place{0};  ///< in the face's frame
};

/// The skin at a place of the picture, px, between the middles of px; nothing where its outer side is not seen.
[[nodiscard]] std::optional<SurfacePlace> place_at(const FaceSurface& surface, double x, double y);

/// How much a walk over the surface turns away from who looks, radians: at each place, between the chords to the places
/// `chord` before and behind it. Positive on a ridge, negative in a hollow; 0 where a chord is missing.
[[nodiscard]] std::vector<double> turns_of(const std::vector<std::optional<SurfacePlace>>& walk, std::size_t chord);

/// The number of the part of the mesh that a triangle is of.
[[nodiscard]] std::size_t part_of(const mesh::TriangleMesh& mesh, std::uint32_t triangle);

}  // namespace penpose::portrait
