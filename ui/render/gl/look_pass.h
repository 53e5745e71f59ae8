#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "ui/render/gl/gl_program.h"
#include "ui/render/gl/textures.h"
#include "ui/render/gl/view.h"
#include "ui/render/scene.h"

namespace penpose::render {

/// Draws the triangles of a mesh that have pictures and colours of their own. They lie among the indices of the mesh,
/// whose vertex array is bound whenever something of this is called.
class LookPass {
 public:
  static base::Result<LookPass> make();
  LookPass() = default;
  ~LookPass();
  LookPass(LookPass&& other) noexcept;
  LookPass& operator=(LookPass&& other) noexcept;

  /// Whether the look is one of a mesh of that many vertices and triangles.
  [[nodiscard]] static bool fits(const Appearance& appearance, std::size_t vertices, std::size_t triangles);

  /// Puts the corners of the look's triangles behind the indices; of none where it is not `shown`.
  void add_indices(const Appearance& appearance, bool shown, std::span<const mesh::Triangle> triangles,
                   std::vector<std::uint32_t>& indices);
  /// Sends coordinates, colours and pictures of what was added last.
  void upload(const Appearance& appearance, std::size_t vertex_count);
  /// Puts translucent triangles into the order in which this view sees them, the farthest first.
  void order(const Scene& scene, const View& view);

  /// What is opaque, cut out, or of what is blended as good as opaque.
  void draw_opaque(const View& view) const;
  [[nodiscard]] bool blends() const { return !blended_.empty(); }
  void draw_blended(const View& view) const;

  /// Pictures that could not be unpacked, as Textures tells them.
  [[nodiscard]] std::vector<std::string> take_undrawn() { return textures_.take_undrawn(); }

 private:
  /// A batch of the look as it lies among the indices.
  struct Batch {
    LookBatch of;
    std::size_t first_index = 0;
    std::vector<mesh::Triangle> triangles;  ///< of blended ones, which are sorted
  };

  void draw_batch(const Batch& batch, float least_alpha) const;

  GlProgram program_;
  Textures textures_;
  std::shared_ptr<const document::Look> look_;
  std::vector<Batch> batches_;
  std::vector<std::size_t> blended_;  ///< of batches_, in the order in which they are drawn
  unsigned coordinates_ = 0;
  unsigned tint_ = 0;
};

}  // namespace penpose::render
