#include "ui/app/cast/cast_frame.h"

#include <algorithm>

#include "ui/app/view/draw_frame.h"

namespace penpose::app {
namespace {

/// So much of the ground shows through those that are not worked on.
constexpr float k_recede_alpha = 0.45F;

}  // namespace

std::pair<bool, bool> CastFrame::look_at(const std::vector<render::ScenePart>& parts, std::vector<Seen> seen) {
  const auto same_mesh = [](const Seen& a, const Seen& b) {
    return a.model->mesh == b.model->mesh && a.shape == b.shape;
  };
  const auto same_pose = [](const Seen& a, const Seen& b) {
    return a.model == b.model && a.pose == b.pose && a.placement == b.placement;
  };
  const bool shape = !std::equal(seen.begin(), seen.end(), seen_.begin(), seen_.end(), same_mesh);
  const bool pose = shape || !std::equal(seen.begin(), seen.end(), seen_.begin(), seen_.end(), same_pose);
  seen_ = std::move(seen);
  vertices_ = 0;
  for (const render::ScenePart& part : parts) vertices_ += part.positions.size();
  return {shape, pose};
}

void CastFrame::forget() {
  seen_.clear();
  triangles_.reset();
  appearance_.reset();
  positions_.reset();
  normals_.reset();
  own_overlay_.reset();
  overlay_.reset();
}

void CastFrame::lay_over(const std::shared_ptr<const std::vector<render::Color>>& overlay, const render::Color& ground,
                         bool recedes) {
  own_overlay_ = overlay;
  ground_ = ground;
  recedes_ = recedes;
  const render::Color beside{ground.r, ground.g, ground.b, recedes ? k_recede_alpha : 0.0F};
  std::vector<render::Color> colors(vertices_, beside);
  const std::size_t count = seen_[active_].model->mesh->vertex_count();
  const auto own = colors.begin() + static_cast<std::ptrdiff_t>(active_first_);
  std::fill_n(own, count, render::Color{0, 0, 0, 0});
  if (overlay && overlay->size() == count) std::copy(overlay->begin(), overlay->end(), own);
  overlay_ = std::make_shared<const std::vector<render::Color>>(std::move(colors));
  ++overlay_number_;
}

void CastFrame::put_into(DrawFrame& frame, const Cast& cast, const PosedSurface& active,
                         const std::shared_ptr<const std::vector<render::Color>>& overlay,
                         const render::Color& ground) {
  std::vector<render::ScenePart> parts;
  std::vector<Seen> seen;
  std::size_t active_part = 0;
  std::size_t active_first = 0;
  std::size_t vertices = 0;
  for (std::size_t i = 0; i < cast.size(); ++i) {
    const Character& one = cast.at(i);
    const bool is_active = i == cast.active();
    if (!is_active && (!one.shown || !one.posed_at_s)) continue;
    const PosedSurface& surface = is_active ? active : one.surface;
    const geometry::Placement placement = is_active ? geometry::Placement() : cast.beside(i);
    if (is_active) active_part = parts.size();
    if (is_active) active_first = vertices;
    parts.push_back({&surface.model(), &surface.appearance(), placement, surface.positions(), surface.normals()});
    seen.push_back({surface.shared_model(), surface.shape_number(), surface.pose_number(), placement});
    vertices += surface.positions().size();
  }
  const bool moved = active_ != active_part || active_first_ != active_first;
  active_ = active_part;
  active_first_ = active_first;
  const auto [other_shape, pose] = look_at(parts, std::move(seen));
  // The one that is worked on has the shadow on the ground.
  const bool shape = other_shape || (moved && appearance_->light);
  if (shape) {
    render::MergedShape merged = render::merged_shape(parts);
    triangles_ = std::make_shared<const std::vector<mesh::Triangle>>(std::move(merged.triangles));
    appearance_ = std::make_shared<const render::Appearance>(std::move(merged.appearance));
    ++shape_number_;
  }
  if (pose) {
    render::MergedPose merged = render::merged_pose(parts);
    positions_ = std::make_shared<const std::vector<glm::vec3>>(std::move(merged.positions));
    normals_ = std::make_shared<const std::vector<glm::vec3>>(std::move(merged.normals));
    ++pose_number_;
  }
  if (shape || moved || !overlay_ || overlay != own_overlay_ || !(ground == ground_) || cast.recedes() != recedes_)
    lay_over(overlay, ground, cast.recedes());
  frame.triangles = triangles_;
  frame.appearance = appearance_;
  frame.positions = positions_;
  frame.normals = normals_;
  frame.overlay = overlay_;
  frame.shape_number = shape_number_;
  frame.pose_number = pose_number_;
  frame.overlay_number = overlay_number_;
}

}  // namespace penpose::app
