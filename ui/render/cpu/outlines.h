#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "ui/render/cpu/shading/texture_map.h"
#include "ui/render/cpu/triangles/screen_vertices.h"
#include "ui/render/draw_list.h"
#include "ui/render/kept_pictures.h"

namespace penpose::render {

/// The lines around toon surfaces, which are their backs, a little larger.
class Outlines {
 public:
  /// Takes down how wide the line is at each vertex.
  void take(const DrawList& list, const document::Look* look, const KeptPictures<TextureMap>& textures,
            std::size_t vertex_count);
  [[nodiscard]] bool empty() const { return widths_.empty(); }
  /// Places the vertices of the lines behind those of the model.
  void place(const Raster& raster, std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
             std::vector<ScreenVertex>& placed);

 private:
  std::vector<glm::vec2> widths_;  ///< one a vertex: in model units, and in heights of the picture; empty: no lines
  std::vector<glm::vec3> positions_;
  std::vector<ScreenVertex> placed_;
};

}  // namespace penpose::render
