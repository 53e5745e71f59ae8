#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <vector>

#include "core/base/result.h"
#include "core/geometry/camera.h"
#include "ui/render/gl/gl_program.h"
#include "ui/render/gl/textures.h"
#include "ui/render/scene.h"

namespace penpose::render {

/// Where the model lies and how the camera sees it, in numbers of moderate size whatever the model's units: the middle
/// of the box is moved to the origin and its diagonal scaled to one.
struct View {
  glm::vec3 middle{0};
  float scale = 1;
  glm::mat4 to_view{1};
  glm::mat4 to_clip{1};
  glm::vec2 depth_to_z{1, 0};   ///< z = 1 / (x * depth + y), in scaled units
  glm::vec2 image_plane{1, 1};  ///< half width and half height at distance 1
};
[[nodiscard]] View make_view(std::span<const glm::vec3> positions, const geometry::Camera& camera);

/// Draws surfaces. Keeps vertex and index buffers of the current context between pictures.
class MeshPass {
 public:
  static base::Result<MeshPass> make();
  MeshPass() = default;
  ~MeshPass();
  MeshPass(MeshPass&& other) noexcept;
  MeshPass& operator=(MeshPass&&) = delete;
  MeshPass(const MeshPass&) = delete;
  MeshPass& operator=(const MeshPass&) = delete;

  /// Sends what has changed. Errors: arrays of different sizes, an index out of range.
  base::Status upload(const Scene& scene);
  /// Puts translucent triangles with pictures into the order in which this view sees them, the farthest first.
  void order(const Scene& scene, const View& view);
  /// Pictures that could not be unpacked, as Textures tells them.
  [[nodiscard]] std::vector<std::string> take_undrawn() { return textures_.take_undrawn(); }
  /// Opaque surfaces into the current framebuffer.
  void draw_opaque(const View& view, bool wireframe) const;
  void draw_translucent(const View& view) const;

 private:
  /// A batch of the look as it lies among the indices.
  struct Batch {
    LookBatch of;
    std::size_t first_index = 0;
    std::vector<mesh::Triangle> triangles;  ///< of blended ones, which are sorted
  };

  void set_view(const GlProgram& program, const View& view) const;
  void upload_shape(const Scene& scene);
  void upload_look(const Appearance& appearance);
  void draw_batch(const Batch& batch, float least_alpha) const;

  GlProgram surface_;
  GlProgram wire_;
  GlProgram looks_;
  Textures textures_;
  std::shared_ptr<const document::Look> look_;
  std::vector<Batch> batches_;
  std::vector<std::size_t> blended_;  ///< of batches_, in the order in which they are drawn
  unsigned coordinates_ = 0;
  unsigned tint_ = 0;
  bool clay_ = false;
  unsigned vertex_array_ = 0;
  unsigned positions_ = 0;
  unsigned normals_ = 0;
  unsigned finish_ = 0;
  unsigned overlay_ = 0;
  unsigned indices_ = 0;
  std::size_t vertex_count_ = 0;
  std::size_t triangle_count_ = 0;
  int opaque_count_ = 0;
  int translucent_count_ = 0;
  int edge_count_ = 0;
  std::size_t first_edge_ = 0;  ///< among the indices
  bool has_edges_ = false;
  std::uint64_t shape_number_ = 0;
  std::uint64_t pose_number_ = 0;
  std::uint64_t overlay_number_ = 0;
  bool overlay_is_clear_ = false;
};

}  // namespace penpose::render
