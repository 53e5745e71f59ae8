#include "core/portrait/surface/face_surface.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "core/mesh/topology.h"

namespace penpose::portrait {
namespace {

/// Rows of the picture.
constexpr double k_rows = 700;
/// Triangles cover a face no more often than this.
constexpr double k_most_layers = 300;
/// Of the one in which the skin is looked for.
constexpr double k_coarse_rows = 160;
/// How far the picture may go beyond what shapes move, as a share of its height: as far as the skin goes there.
constexpr double k_beyond = 0.7, k_margin = 0.03;

/// Of a picture of a box, which is not much wider than high.
double height_of(const geometry::Box& box) {
  return std::max(box.maximum.y - box.minimum.y, (box.maximum.x - box.minimum.x) * 0.5);
}

double turn(const ModelPoint& a, const ModelPoint& b, const ModelPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// How often triangles cover the box of all places, seen along z; half of a triangle's own box counts.
double layers_of(std::span<const ModelPoint> places, std::span<const mesh::Triangle> triangles) {
  geometry::Box box;
  for (const ModelPoint& p : places) box.add(p);
  double covered = 0;
  for (const mesh::Triangle& t : triangles) {
    geometry::Box own;
    for (const std::uint32_t v : t) own.add(places[v]);
    covered += 0.5 * (own.maximum.x - own.minimum.x) * (own.maximum.y - own.minimum.y);
  }
  const double all = box.empty() ? 0.0 : (box.maximum.x - box.minimum.x) * (box.maximum.y - box.minimum.y);
  return all > 0.0 ? covered / all : 0.0;
}

}  // namespace

void FaceSurface::sort_triangles() {
  const auto components = mesh_->components();
  first_triangle_.assign(mesh_->component_count() + 1, 0);
  for (const mesh::Triangle& t : mesh_->triangles()) ++first_triangle_[components[t[0]] + 1];
  for (std::size_t c = 0; c + 1 < first_triangle_.size(); ++c) first_triangle_[c + 1] += first_triangle_[c];
  std::vector<std::uint32_t> next(first_triangle_.begin(), first_triangle_.end() - 1);
  by_component_.resize(mesh_->triangle_count());
  for (std::uint32_t t = 0; t < by_component_.size(); ++t) {
    by_component_[next[components[mesh_->triangles()[t][0]]]++] = t;
  }
}

std::span<const std::uint32_t> FaceSurface::triangles_of(std::uint32_t component) const {
  return std::span(by_component_)
      .subspan(first_triangle_[component], first_triangle_[component + 1] - first_triangle_[component]);
}

std::uint32_t FaceSurface::find_skin(const intent::WholeModel& whole) const {
  // Most of what is seen, weighted by how far shapes move it.
  FaceImage all(place_.box, height_of(place_.box) / k_coarse_rows);
  std::vector<std::uint32_t> every(mesh_->triangle_count());
  for (std::uint32_t t = 0; t < every.size(); ++t) every[t] = t;
  all.draw(places_, mesh_->triangles(), every);
  const intent::ControlFields& fields = *whole.fields;
  std::vector<double> moved(mesh_->component_count(), place_.of_shapes ? 0.0 : 1.0);
  if (place_.of_shapes) {
    std::vector<double> counts(moved.size(), 0.0);
    const std::vector<double> ways = moved_by_shapes(whole);
    for (std::size_t i = 0; i < ways.size(); ++i) {
      const std::uint32_t c = mesh_->components()[fields.samples()[i]];
      moved[c] += ways[i];
      counts[c] += 1.0;
    }
    for (std::size_t c = 0; c < moved.size(); ++c) moved[c] = counts[c] > 0.0 ? moved[c] / counts[c] : 0.0;
  }
  std::vector<double> seen(moved.size(), 0.0);
  for (int y = 0; y < all.height(); ++y) {
    for (int x = 0; x < all.width(); ++x) {
      const std::uint32_t t = all.triangle(x, y);
      if (t != FaceImage::k_nothing) seen[mesh_->components()[mesh_->triangles()[t][0]]] += 1.0;
    }
  }
  std::uint32_t best = 0;
  for (std::uint32_t c = 0; c < seen.size(); ++c) {
    if (seen[c] * moved[c] > seen[best] * moved[best]) best = c;
  }
  return best;
}

geometry::Box FaceSurface::shown() const {
  geometry::Box skin;
  for (std::size_t v = 0; v < places_.size(); ++v) {
    if (mesh_->components()[v] == skin_) skin.add(places_[v]);
  }
  geometry::Box box = place_.box;
  if (skin.empty()) return box;
  const double beyond = k_beyond * (box.maximum.y - box.minimum.y);
  box.minimum = glm::max(skin.minimum, box.minimum - ModelVector{beyond});
  box.maximum = glm::min(skin.maximum, box.maximum + ModelVector{beyond});
  const double margin = k_margin * (box.maximum.y - box.minimum.y);
  box.minimum -= ModelVector{margin};
  box.maximum += ModelVector{margin};
  return box;
}

std::optional<FaceSurface> FaceSurface::look_at(const mesh::TriangleMesh& mesh, const intent::WholeModel& whole,
                                                double front_yaw_degrees) {
  // No model has so many layers; to look at them would take minutes.
  if (layers_of(*whole.rest, mesh.triangles()) > k_most_layers) return std::nullopt;
  const auto place = place_face(mesh, whole, front_yaw_degrees);
  if (!place || !(height_of(place->box) > 0.0)) return std::nullopt;
  FaceSurface surface;
  surface.mesh_ = &mesh;
  surface.place_ = *place;
  for (const ModelPoint& p : *whole.rest) surface.places_.push_back(place->frame.local(p));
  surface.sort_triangles();
  surface.skin_ = surface.find_skin(whole);
  surface.find_borders();
  const geometry::Box box = surface.shown();
  const double height = height_of(box);
  if (!(height > 0.0)) return std::nullopt;
  surface.image_.emplace(box, height / k_rows);
  surface.image_->draw(surface.places_, mesh.triangles(), surface.triangles_of(surface.skin_));
  return surface;
}

bool FaceSurface::shows_skin(int x, int y) const {
  if (!image_->inside(x, y) || image_->triangle(x, y) == FaceImage::k_nothing) return false;
  const mesh::Triangle& t = mesh_->triangles()[image_->triangle(x, y)];
  return turn(places_[t[0]], places_[t[1]], places_[t[2]]) > 0.0;
}

bool FaceSurface::near_border(int x, int y, double within) const {
  const ModelPoint place = position(at(x, y));
  return std::any_of(border_.begin(), border_.end(),
                     [&](const ModelPoint& p) { return geometry::distance(p, place) < within; });
}

void FaceSurface::find_borders() {
  std::vector<bool> is_border(places_.size(), false);
  std::vector<mesh::Triangle> welded;
  for (const std::uint32_t number : triangles_of(skin_)) {
    mesh::Triangle t = mesh_->triangles()[number];
    for (std::uint32_t& v : t) v = mesh_->weld()[v];
    welded.push_back(t);
  }
  const auto edges = mesh::sorted_edges(welded, places_.size());
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i + 1;
    while (end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high) ++end;
    if (end == i + 1) is_border[edges[i].low] = is_border[edges[i].high] = true;
    i = end;
  }
  for (std::size_t v = 0; v < is_border.size(); ++v) {
    if (is_border[v]) border_.push_back(places_[v]);
  }
}

bool FaceSurface::parted(int x0, int y0, int x1, int y1) const {
  const mesh::Triangle& a = mesh_->triangles()[image_->triangle(x0, y0)];
  const mesh::Triangle& b = mesh_->triangles()[image_->triangle(x1, y1)];
  const auto weld = mesh_->weld();
  for (const std::uint32_t u : a) {
    for (const std::uint32_t v : b) {
      if (weld[u] == weld[v]) return false;
    }
  }
  return true;
}

mesh::MeshPoint FaceSurface::at(int x, int y) const {
  const std::uint32_t number = image_->triangle(x, y);
  const mesh::Triangle& t = mesh_->triangles()[number];
  return {number, seen_barycentric(image_->place(x, y), places_[t[0]], places_[t[1]], places_[t[2]])};
}

ModelPoint FaceSurface::position(const mesh::MeshPoint& point) const {
  return mesh::position_of(point, mesh_->triangles(), places_);
}

}  // namespace penpose::portrait
