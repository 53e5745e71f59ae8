#include "core/portrait/surface/parting.h"

#include <algorithm>

namespace penpose::portrait {
namespace {

/// A control that moves nothing farther than this share of the face does nothing there.
constexpr double k_least_parting_way = 0.002;

}  // namespace

PushField::PushField(const rig::Rig& rig, const FaceSurface& surface, std::span<const std::uint32_t> vertices)
    : surface_(surface),
      rest_(rig::rest_pose(rig)),
      vertices_(vertices.begin(), vertices.end()),
      bound_(rig.bind(vertices_)),
      at_rest_(vertices_.size()),
      at_push_(vertices_.size()),
      ways_(surface.places().size(), ModelVector{0}) {
  bound_->evaluate(rest_, at_rest_);
}

void PushField::set(const Push& push) {
  rig::Pose pose = rest_;
  pose[push.control] = push.value;
  bound_->evaluate(pose, at_push_);
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    ways_[vertices_[i]] = surface_.place().frame.turned(at_push_[i] - at_rest_[i]);
  }
}

ModelVector PushField::of(const mesh::MeshPoint& point) const {
  const mesh::Triangle& t = surface_.mesh().triangles()[point.triangle];
  ModelVector sum{0};
  for (std::size_t i = 0; i < 3; ++i) sum += ways_[t[i]] * point.barycentric[i];
  return sum;
}

std::vector<Push> pushes_within(const rig::Rig& rig, const intent::WholeModel& whole, const FaceSurface& surface,
                                const geometry::Box& box) {
  const intent::ControlFields& fields = *whole.fields;
  std::vector<bool> within(fields.places().size());
  for (std::size_t i = 0; i < fields.places().size(); ++i) {
    const ModelPoint p = surface.place().frame.local(fields.places()[i]);
    within[i] = p.x >= box.minimum.x && p.x <= box.maximum.x && p.y >= box.minimum.y && p.y <= box.maximum.y;
  }
  const double least = k_least_parting_way * surface.place().box.diagonal();
  std::vector<Push> pushes;
  for (std::size_t k = 0; k < fields.control_count(); ++k) {
    const intent::ControlField field = fields.field(k);
    bool parts = false;
    for (std::size_t i = 0; i < field.samples.size() && !parts; ++i)
      parts = within[field.samples[i]] && geometry::length(field.ways[i]) > least;
    if (!parts) continue;
    const rig::Parameter& p = rig.parameters()[k];
    const double room = p.maximum - p.minimum;
    if (p.maximum - p.rest > 0.05 * room) pushes.push_back({k, p.maximum});
    if (p.rest - p.minimum > 0.05 * room) pushes.push_back({k, p.minimum});
  }
  return pushes;
}

std::vector<std::uint32_t> vertices_seen(const FaceSurface& surface, int x0, int y0, int x1, int y1) {
  std::vector<std::uint32_t> seen;
  const FaceImage& image = surface.image();
  for (int y = std::max(0, y0); y <= std::min(image.height() - 1, y1); ++y) {
    std::uint32_t last = FaceImage::k_nothing;
    for (int x = std::max(0, x0); x <= std::min(image.width() - 1, x1); ++x) {
      const std::uint32_t t = image.triangle(x, y);
      if (t == last || t == FaceImage::k_nothing) continue;
      last = t;
      for (const std::uint32_t v : surface.mesh().triangles()[t]) seen.push_back(v);
    }
  }
  std::stable_sort(seen.begin(), seen.end());
  seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
  return seen;
}

}  // namespace penpose::portrait
