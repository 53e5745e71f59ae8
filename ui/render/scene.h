#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/document/look.h"
#include "core/geometry/space.h"
#include "core/mesh/triangle_mesh.h"
#include "ui/render/picture/color.h"

namespace penpose::render {

/// How a surface takes light.
struct Surface {
  Color base_color{0.62F, 0.60F, 0.58F, 1};  ///< alpha below one: drawn after everything opaque, one sees through
  float roughness = 0.55F;                   ///< 0 polished .. 1 chalk
  float metallic = 0;
};

/// Triangles that are drawn as one surface of a document::Look has it.
struct LookBatch {
  std::uint32_t surface = 0;
  std::uint32_t first = 0;  ///< into Appearance::look_triangles
  std::uint32_t count = 0;
  float roughness = 0.8F;
  float metallic = 0;
  bool moves = false;  ///< blend shapes move something of it: its picture stays sharp where memory is short
};

/// Soft shadows of a model at rest, which cost a picture next to nothing (bake_light).
struct BakedLight {
  std::vector<std::uint8_t> sky;  ///< one a vertex: how much of the sky it sees, 255: all of it
  /// Where it stands: a square on the ground around `ground`, and how dark it is in rows along z of columns along x.
  static constexpr int k_ground_px = 64;
  glm::vec3 ground{0};
  float half_side = 0;                     ///< model units; zero: there is no ground
  std::vector<std::uint8_t> ground_shade;  ///< 255: no light at all
};

/// How a mesh looks, apart from its pose. Vertices of one triangle share a surface.
struct Appearance {
  std::vector<Surface> surfaces;
  std::vector<std::uint16_t> surface_of_vertex;  ///< one a vertex; empty: the first surface for all
  /// One a vertex or empty: distance from the gaze axis in eyeball radii (0 the middle of the pupil); 1 and above: no
  /// eye. The renderer paints iris and pupil there.
  std::vector<float> gaze;
  std::vector<float> opacity;  ///< one a vertex or empty: multiplies the alpha of a translucent surface
  std::shared_ptr<const document::Look> look{};  ///< pictures and colours that the file gives; null: none
  std::vector<std::uint32_t> look_triangles{};   ///< drawn as the look has it, a batch after the other
  std::vector<LookBatch> batches{};
  std::shared_ptr<const BakedLight> light{};  ///< soft shadows; null: none
};

/// The three curves of a sketch and their colours: reference green, target blue, constraint red.
enum class CurveKind : std::uint8_t { reference, target, constraint };
[[nodiscard]] Color curve_color(CurveKind kind);

/// A curve that is drawn over everything, antialiased, with a thin dark outline. One point draws a dot.
struct CurveDrawing {
  std::vector<geometry::ModelPoint> points;
  std::vector<geometry::PxPoint> points_px;  ///< used in place of `points` when not empty: a stroke still on the glass
  CurveKind kind = CurveKind::reference;
  std::optional<Color> color;       ///< in place of the kind's
  std::vector<Color> point_colors;  ///< in place of `color`, one a point
  float width_px = 4;
  std::vector<float> widths_px;  ///< in place of `width_px`, one a point (pen pressure)
  bool closed = false;
  bool highlighted = false;  ///< a light halo around it
};

/// How far darkening of creases looks, as a share of the model's diagonal (which a View scales to one).
inline constexpr float k_occlusion_radius = 0.06F;

/// The backdrop, from the top of the picture to its foot.
struct Background {
  Color top = from_srgb(0x5b6470);
  Color bottom = from_srgb(0x24282e);
  float vignette = 0.5F;  ///< how much darker it is towards the corners; 0: it is not
};

[[nodiscard]] bool same_background(const Background& a, const Background& b);

/// What a picture shows. Spans are read during the call only.
///
/// The three numbers let a renderer keep what it has sent to the graphics card: data is sent again when its number has
/// changed, and always when it is 0.
struct Scene {
  std::span<const glm::vec3> positions;  ///< world positions, model units
  std::span<const glm::vec3> normals;    ///< one a position, length one
  std::span<const mesh::Triangle> triangles;
  const Appearance* appearance = nullptr;  ///< null: one plain grey surface
  std::span<const Color> overlay;          ///< one a vertex or empty: laid over the surface's colour by its alpha
  std::span<const CurveDrawing> curves;
  Background background;
  bool wireframe = false;
  bool clay = false;    ///< without the pictures and colours of the appearance's look
  bool matcap = false;  ///< that, and lit as a ball is: the same light wherever a surface looks the same way

  std::uint64_t shape_number = 0;  ///< of triangles and appearance
  std::uint64_t pose_number = 0;   ///< of positions and normals
  std::uint64_t overlay_number = 0;
};

}  // namespace penpose::render
