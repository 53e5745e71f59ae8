#pragma once

#include <cstdint>
#include <vector>

#include "core/base/result.h"
#include "ui/render/draw_list.h"
#include "ui/render/gl/gl_program.h"
#include "ui/render/gl/mesh/look_pass.h"
#include "ui/render/gl/mesh/mesh_buffers.h"
#include "ui/render/scene.h"

namespace penpose::render {

/// Draws surfaces. Keeps vertex and index buffers of the current context between pictures.
class MeshPass {
 public:
  static base::Result<MeshPass> make(const GlDialect& dialect);

  /// Sends what has changed. Errors: arrays of different sizes, an index out of range.
  base::Status upload(const Scene& scene);
  /// As order_blended.
  void order(const Scene& scene, const View& view);
  /// Pictures that could not be unpacked, as Textures tells them.
  [[nodiscard]] std::vector<std::string> take_undrawn() { return looks_.take_undrawn(); }
  /// Whether anything of the last scene has two tones.
  [[nodiscard]] bool has_toon() const { return toon_; }
  /// Opaque surfaces into the current framebuffer.
  void draw_opaque(const View& view, bool wireframe) const;
  void draw_translucent(const View& view) const;

 private:
  MeshPass(const GlDialect& dialect, GlProgram surface, GlProgram wire, LookPass looks);
  void upload_shape(const Scene& scene);
  void upload_finish(const Scene& scene);
  void upload_pose(const Scene& scene);
  void upload_overlay(const Scene& scene);

  GlProgram surface_;
  GlProgram wire_;
  LookPass looks_;
  SceneTracker tracker_;
  DrawList list_;                         ///< without what the card alone has to know
  std::vector<std::size_t> first_index_;  ///< of each batch
  MeshBuffers buffers_;
  unsigned positions_ = 0;
  unsigned normals_ = 0;
  unsigned finish_ = 0;
  unsigned overlay_ = 0;
  unsigned light_ = 0;
  bool matcap_ = false;
  bool toon_ = false;
  std::size_t opaque_count_ = 0;  ///< indices
  std::size_t translucent_count_ = 0;
  std::size_t edge_count_ = 0;
  std::size_t first_edge_ = 0;  ///< among the indices
};

}  // namespace penpose::render
