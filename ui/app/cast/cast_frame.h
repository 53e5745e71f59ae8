#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "ui/app/cast/cast.h"
#include "ui/render/merged.h"

namespace penpose::app {

struct DrawFrame;

/// The characters that are shown, drawn as one surface in the space of the one that is worked on. What has not changed
/// since the frame before is shared with it.
class CastFrame {
 public:
  /// Puts the characters into a frame in place of the one that is worked on. `active`: its surface; `overlay`: its
  /// colours laid over, null for none; `ground`: what the others fade into.
  void put_into(DrawFrame& frame, const Cast& cast, const PosedSurface& active,
                const std::shared_ptr<const std::vector<render::Color>>& overlay, const render::Color& ground);
  /// One character alone is drawn.
  void forget();

 private:
  /// What a part of the surface is drawn of.
  struct Seen {
    std::shared_ptr<const document::Model> model;
    std::uint64_t shape = 0;
    std::uint64_t pose = 0;
    geometry::Placement placement;
  };
  /// Takes what is shown now; whether shapes differ from before, and poses.
  std::pair<bool, bool> look_at(const std::vector<render::ScenePart>& parts, std::vector<Seen> seen);
  void lay_over(const std::shared_ptr<const std::vector<render::Color>>& overlay, const render::Color& ground,
                bool recedes);

  static constexpr std::uint64_t k_first_number = std::uint64_t{1} << 40;
  std::vector<Seen> seen_;
  std::size_t active_ = 0;        ///< of the parts
  std::size_t active_first_ = 0;  ///< vertex
  std::size_t vertices_ = 0;
  std::shared_ptr<const std::vector<mesh::Triangle>> triangles_;
  std::shared_ptr<const render::Appearance> appearance_;
  std::shared_ptr<const std::vector<glm::vec3>> positions_;
  std::shared_ptr<const std::vector<glm::vec3>> normals_;
  std::shared_ptr<const std::vector<render::Color>> own_overlay_;  ///< that the merged one was made of
  std::shared_ptr<const std::vector<render::Color>> overlay_;
  render::Color ground_;
  bool recedes_ = false;
  /// Unlike those of one character alone.
  std::uint64_t shape_number_ = k_first_number, pose_number_ = k_first_number, overlay_number_ = k_first_number;
};

}  // namespace penpose::app
