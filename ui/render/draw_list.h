#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "ui/render/packed_color.h"
#include "ui/render/scene.h"
#include "ui/render/view.h"

namespace penpose::render {

/// What of a scene differs from the one before.
struct SceneChanges {
  bool shape = false;    ///< triangles or appearance
  bool pose = false;     ///< positions or normals
  bool overlay = false;  ///< colours laid over
};

/// Compares each scene with the one before by its numbers and sizes.
class SceneTracker {
 public:
  /// Errors: arrays of different sizes, an index out of range, an appearance of another mesh. The scene then counts as
  /// not seen.
  base::Result<SceneChanges> look_at(const Scene& scene);

 private:
  std::size_t vertices_ = 0;
  std::size_t triangles_ = 0;
  std::uint64_t shape_ = 0, pose_ = 0, overlay_ = 0;
  bool overlay_is_clear_ = false;
  bool clay_ = false;
  bool matcap_ = false;
  bool edges_ = false;
};

/// The triangles of a scene by the way in which they are drawn.
struct DrawList {
  struct Batch {
    LookBatch of;
    std::vector<mesh::Triangle> triangles;
  };
  std::vector<mesh::Triangle> opaque;  ///< of plain surfaces
  std::vector<mesh::Triangle> translucent;
  std::vector<Batch> batches;        ///< of the look, where it is shown
  std::vector<std::size_t> blended;  ///< those of `batches` that are blended, in the order in which they are drawn
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;  ///< of opaque triangles, each once; where asked for
};
/// Precondition: a SceneTracker took the scene.
[[nodiscard]] DrawList make_draw_list(const Scene& scene);

/// Puts blended triangles, and the batches that have them, into the order in which this view sees them, the farthest
/// first. `sorted` is called with each batch whose triangles have changed places.
template <typename Sorted>
void order_blended(DrawList& list, const Scene& scene, const View& view, const Sorted& sorted);

/// Of what is blended, all that is as good as opaque hides what is behind it, and all that is hardly there is left out.
inline constexpr float k_nearly_opaque = 0.98F;
inline constexpr float k_nearly_clear = 0.004F;
/// What of a surface is fainter than this does not hide what is behind it; below zero: all of it hides.
[[nodiscard]] float least_alpha(const document::Surface& surface);

/// Where texture coordinates come to lie: along_u * u + along_v * v + shift (KHR_texture_transform).
struct TextureTransform {
  glm::vec2 along_u{1, 0};
  glm::vec2 along_v{0, 1};
  glm::vec2 shift{0, 0};
};
[[nodiscard]] TextureTransform transform_of(const document::TextureUse& use);

/// What of a vertex its surface says: base colour as `pack` gives it, and roughness, metallic, gaze and opacity.
using VertexFinish = std::array<Bytes4, 2>;
[[nodiscard]] std::vector<VertexFinish> vertex_finish(const Scene& scene);
/// What reaches a vertex: how much of the sky (Appearance::light), how much of it is the wet front of an eye; two bytes
/// that say nothing.
[[nodiscard]] std::vector<Bytes4> vertex_light(const Scene& scene);
/// Whether anything of it has two tones, which creases must not soil.
[[nodiscard]] bool has_toon(const DrawList& list, const Appearance* appearance);
/// Whether a line is drawn around it.
[[nodiscard]] bool has_outline(const document::Surface& surface);
/// How far an outline stands out in a view's units: everywhere, and for each unit of distance.
[[nodiscard]] glm::vec2 outline_reach(const document::Toon& toon, const View& view);
/// The look's colours of vertices as `pack` gives them; white where it has none.
[[nodiscard]] std::vector<Bytes4> vertex_tint(const document::Look& look, std::size_t vertex_count);

namespace internal {
/// Sorts one batch; true when triangles have changed places. Gives the mean depth of the batch.
bool order_batch(DrawList::Batch& batch, const Scene& scene, const View& view, double& depth);
void order_batches(DrawList& list, const std::vector<double>& depths);
}  // namespace internal

template <typename Sorted>
void order_blended(DrawList& list, const Scene& scene, const View& view, const Sorted& sorted) {
  if (list.blended.empty()) return;
  std::vector<double> depths(list.batches.size(), 0);
  for (const std::size_t b : list.blended) {
    if (internal::order_batch(list.batches[b], scene, view, depths[b])) sorted(b);
  }
  internal::order_batches(list, depths);
}

}  // namespace penpose::render
