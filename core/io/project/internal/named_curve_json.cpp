#include "core/io/project/internal/named_curve_json.h"

#include <cmath>

namespace penpose::io {
namespace {

std::optional<mesh::MeshPoint> mesh_point_of(const json::Json& value) {
  if (!value.is_array() || value.size() != 4) return std::nullopt;
  const auto triangle = json::whole_number(value[0], 0, 0xffffffffLL);
  if (!triangle) return std::nullopt;
  mesh::MeshPoint point{static_cast<std::uint32_t>(*triangle), {}};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto share = json::number(value[k + 1]);
    if (!share || std::abs(*share) > 1e15) return std::nullopt;
    point.barycentric.at(k) = *share;
  }
  return point;
}

}  // namespace

std::optional<base::Error> read_named_curve(const json::Json& value, const std::string& pointer, const char* remedy,
                                            document::NamedCurve& out) {
  const json::Json* name = json::find(value, "name");
  const json::Json* points = json::find(value, "points");
  if (name == nullptr || !name->is_string()) return base::Error{"a name was expected", pointer, remedy};
  if (points == nullptr || !points->is_array()) return base::Error{"a list of points was expected", pointer, remedy};
  out.name = name->get<std::string>();
  for (std::size_t i = 0; i < points->size(); ++i) {
    const auto point = mesh_point_of((*points)[i]);
    if (!point) {
      return base::Error{"a point [triangle, b0, b1, b2] was expected", json::child(json::child(pointer, "points"), i),
                         remedy};
    }
    out.points.push_back(*point);
  }
  return std::nullopt;
}

std::optional<base::Error> check_named_curves(std::span<const document::NamedCurve> curves, std::size_t triangle_count,
                                              const std::string& pointer, const char* remedy) {
  for (std::size_t c = 0; c < curves.size(); ++c) {
    for (std::size_t i = 0; i < curves[c].points.size(); ++i) {
      const mesh::MeshPoint& point = curves[c].points[i];
      const double sum = point.barycentric[0] + point.barycentric[1] + point.barycentric[2];
      if (point.triangle < triangle_count && std::abs(sum - 1.0) < 1e-6) continue;
      return base::Error{"the point is not on the mesh", json::child(json::child(json::child(pointer, c), "points"), i),
                         remedy};
    }
  }
  return std::nullopt;
}

json::Json to_json(std::span<const document::NamedCurve> curves) {
  json::Json out = json::Json::array();
  for (const document::NamedCurve& curve : curves) {
    json::Json points = json::Json::array();
    for (const mesh::MeshPoint& p : curve.points)
      points.push_back({p.triangle, p.barycentric[0], p.barycentric[1], p.barycentric[2]});
    out.push_back({{"name", curve.name}, {"points", std::move(points)}});
  }
  return out;
}

}  // namespace penpose::io
