#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/mesh/triangle_mesh.h"

namespace penpose::render {

/// What a connected component of a character seems to be.
enum class PartKind : std::uint8_t { surface, eyeball, eye_cover, lash, tooth, gum };

/// An eyeball: a sphere, and where it looks.
struct Eye {
  std::uint32_t component = 0;
  geometry::ModelPoint center{0};
  double radius = 0;
  geometry::ModelVector gaze{0};  ///< towards the bulge of the cornea, length one; zero where there is no bulge
};

struct FaceParts {
  std::vector<PartKind> kind_of_component;
  std::vector<Eye> eyes;
};

/// Tells the parts of a head apart by shape alone, for models in which everything has the skin's material. Most models
/// are no such head; there everything is `surface`.
///
/// The largest component (at least half of the whole area) is the body. A head is one that has exactly two eyes: closed
/// components that are spheres (rms deviation below 6 % of the radius), of equal size (10 %), radius 1 to 12 % of the
/// body's diagonal, middle inside its box. Given eyes,
/// - closed components inside an eyeball belong to it;
/// - an open component that stays within a fifth of the radius of the eyeball's surface is a cover (tear film, shadow
///   shell): opaque, it would hide the eye;
/// - another small open component that begins there is a row of lashes;
/// - eight or more small closed components away from the eyes are teeth, and
/// - a component whose box holds half of them, other than the body, is gums.
///
/// `positions`: world positions at rest, one a vertex.
[[nodiscard]] FaceParts recognise_face_parts(const mesh::TriangleMesh& mesh,
                                             std::span<const geometry::ModelPoint> positions);

/// Eyeballs by what the file calls them ("EyeLeft", "Wolf3D_Eye"): of the vertices that are `called` so, one a vertex,
/// the largest ball or shell of each place, with its gaze zero.
[[nodiscard]] std::vector<Eye> find_called_eyes(const mesh::TriangleMesh& mesh,
                                                std::span<const geometry::ModelPoint> positions,
                                                const std::vector<bool>& called);
/// Whether a name is that of an eyeball, and not of lids, lashes, brows, glasses or shadows about it.
[[nodiscard]] bool names_eyeball(std::string_view name);
/// Where two eyes look that have no bulge: away from the head, at a right angle to the line between them. `positions`
/// are of the whole model, y points up.
[[nodiscard]] geometry::ModelVector forward_of(const Eye& one, const Eye& other,
                                               std::span<const geometry::ModelPoint> positions);

}  // namespace penpose::render
