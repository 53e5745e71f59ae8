#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "ui/render/draw_list.h"
#include "ui/render/gl/gl_program.h"
#include "ui/render/gl/mesh/mesh_buffers.h"
#include "ui/render/gl/mesh/textures.h"
#include "ui/render/scene.h"

namespace penpose::render {

/// Draws the triangles of a mesh that have pictures and colours of their own. They lie among the indices of the mesh,
/// whose buffers are bound when something is drawn.
class LookPass {
 public:
  static base::Result<LookPass> make(const GlDialect& dialect);

  /// Once, before anything is sent.
  void add_to(MeshBuffers& mesh);
  /// Sends coordinates, colours and pictures of what the list has of the look.
  void upload(const Scene& scene, const DrawList& list, MeshBuffers& mesh);
  /// Coordinates and colours again.
  void upload_vertices(const Scene& scene, MeshBuffers& mesh);

  /// What is opaque, cut out, or of what is blended as good as opaque. `first_index`: where each batch begins among the
  /// indices.
  void draw_opaque(const View& view, const DrawList& list, std::span<const std::size_t> first_index,
                   const MeshBuffers& mesh) const;
  void draw_blended(const View& view, const DrawList& list, std::span<const std::size_t> first_index,
                    const MeshBuffers& mesh) const;

  /// Pictures that could not be unpacked, as Textures tells them.
  [[nodiscard]] std::vector<std::string> take_undrawn() { return textures_.take_undrawn(); }

 private:
  LookPass(const GlDialect& dialect, GlProgram program) : program_(std::move(program)), textures_(dialect) {}
  void draw_outlines(const View& view, const DrawList& list, std::span<const std::size_t> first_index,
                     const MeshBuffers& mesh) const;
  void set_batch(const LookBatch& batch, float least_alpha) const;
  void set_toon(const document::Surface& surface) const;
  void draw_batch(const LookBatch& batch, std::size_t first_index, float least_alpha, const MeshBuffers& mesh) const;

  GlProgram program_;
  Textures textures_;
  std::shared_ptr<const document::Look> look_;
  unsigned coordinates_ = 0;
  unsigned tint_ = 0;
};

}  // namespace penpose::render
