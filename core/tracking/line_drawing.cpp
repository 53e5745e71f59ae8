#include "core/tracking/line_drawing.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/geometry/bvh.h"
#include "core/portrait/silhouette.h"

namespace penpose::tracking {
namespace {

using geometry::PxPoint;

/// Shorter parts are left out: a share of the picture's longer side.
constexpr double k_least = 0.01;
/// The least of a contour: folds of a mouth or an ear make many small ones that nobody draws.
constexpr double k_least_contour = 0.05;

double length_of(const std::vector<PxPoint>& line) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length += geometry::distance(line[i - 1], line[i]);
  return length;
}

class Drawer {
 public:
  Drawer(const document::Model& model, const geometry::Camera& camera)
      : camera_(camera), positions_(document::posed_positions(model)), tree_(floats(), model.mesh->triangles()) {
    out_.width = camera.viewport().width;
    out_.height = camera.viewport().height;
  }

  /// The parts of a line that lie in the picture, the longest first.
  [[nodiscard]] std::vector<std::vector<PxPoint>> parts_in_picture(const portrait::SurfaceLine& line) const {
    std::vector<std::vector<PxPoint>> parts(1);
    for (const posing::CurvePoint& point : line) {
      const auto at = camera_.project(portrait::place_of(point, positions_));
      if (at && at->x >= 0.0 && at->x <= out_.width && at->y >= 0.0 && at->y <= out_.height) {
        parts.back().push_back(*at);
      } else if (!parts.back().empty()) {
        parts.emplace_back();
      }
    }
    return parts;
  }
  void add_curve(const portrait::FeatureCurve& curve) {
    std::vector<std::vector<PxPoint>> parts;
    for (const portrait::SurfaceLine& seen : portrait::seen_parts(camera_, curve.points, positions_, tree_)) {
      for (auto& part : parts_in_picture(seen)) parts.push_back(std::move(part));
    }
    std::stable_sort(parts.begin(), parts.end(),
                     [](const auto& a, const auto& b) { return length_of(a) > length_of(b); });
    std::size_t number = 0;
    for (auto& part : parts) {
      if (++number == 1) {
        add(std::move(part), curve.name, k_least);
      } else {
        add(std::move(part), curve.name + "_" + std::to_string(number), k_least);
      }
    }
  }
  void add_contours(const mesh::TriangleMesh& mesh) {
    std::size_t number = 0;
    for (const portrait::SurfaceLine& line : portrait::silhouette(camera_, mesh, positions_, tree_)) {
      for (auto& part : parts_in_picture(line)) {
        if (add(std::move(part), std::string(io::k_contour_name) + "_" + std::to_string(number), k_least_contour))
          ++number;
      }
    }
  }
  [[nodiscard]] io::PictureLines take() { return std::move(out_); }

 private:
  [[nodiscard]] std::vector<glm::vec3> floats() const { return {positions_.begin(), positions_.end()}; }
  /// Whether it was long enough.
  bool add(std::vector<PxPoint> points, std::string name, double least) {
    if (points.size() < 2 || length_of(points) < least * std::max(out_.width, out_.height)) return false;
    out_.lines.push_back({std::move(points), false, out_.lines.size(), std::move(name)});
    return true;
  }

  const geometry::Camera& camera_;
  std::vector<geometry::ModelPoint> positions_;
  geometry::TriangleBvh tree_;
  io::PictureLines out_;
};

}  // namespace

io::PictureLines line_drawing(const document::Model& model, std::span<const portrait::FeatureCurve> curves,
                              const geometry::Camera& camera) {
  Drawer drawer(model, camera);
  for (const portrait::FeatureCurve& curve : curves) drawer.add_curve(curve);
  drawer.add_contours(*model.mesh);
  return drawer.take();
}

}  // namespace penpose::tracking
