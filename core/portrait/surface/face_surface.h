#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/mesh/mesh_point.h"
#include "core/portrait/surface/face_frame.h"
#include "core/portrait/surface/face_image.h"
#include "core/posing/problem.h"

namespace penpose::portrait {

/// The skin of a face as it is seen from its front, and what controls do there.
class FaceSurface {
 public:
  /// Nothing where no face is found: a mesh that is empty or of no extent.
  static std::optional<FaceSurface> look_at(const mesh::TriangleMesh& mesh, const intent::WholeModel& whole,
                                            double front_yaw_degrees);

  [[nodiscard]] const FacePlace& place() const { return place_; }
  [[nodiscard]] const mesh::TriangleMesh& mesh() const { return *mesh_; }
  /// All vertices at rest, in the frame.
  [[nodiscard]] std::span<const ModelPoint> places() const { return places_; }
  /// Of the skin alone.
  [[nodiscard]] const FaceImage& image() const { return *image_; }
  /// The component of the mesh (TriangleMesh::components) that is the skin.
  [[nodiscard]] std::uint32_t skin() const { return skin_; }
  [[nodiscard]] std::span<const std::uint32_t> triangles_of(std::uint32_t component) const;

  /// Whether a px shows the skin's outer side.
  [[nodiscard]] bool shows_skin(int x, int y) const;
  /// Whether two px show parts of the surface that are not next to each other: their triangles have no vertex in
  /// common.
  [[nodiscard]] bool parted(int x0, int y0, int x1, int y1) const;
  /// Whether the surface ends within a distance (model units) of what a px shows.
  [[nodiscard]] bool near_border(int x, int y, double within) const;
  /// The place on the mesh that a px shows. Precondition: something is there.
  [[nodiscard]] mesh::MeshPoint at(int x, int y) const;
  [[nodiscard]] ModelPoint position(const mesh::MeshPoint& point) const;

 private:
  FaceSurface() = default;
  void sort_triangles();
  void find_borders();
  [[nodiscard]] geometry::Box shown() const;
  [[nodiscard]] std::uint32_t find_skin(const intent::WholeModel& whole) const;

  const mesh::TriangleMesh* mesh_ = nullptr;
  FacePlace place_;
  std::vector<ModelPoint> places_;
  std::optional<FaceImage> image_;
  std::uint32_t skin_ = 0;
  std::vector<ModelPoint> border_;             ///< vertices at an edge of one triangle
  std::vector<std::uint32_t> by_component_;    ///< triangles
  std::vector<std::uint32_t> first_triangle_;  ///< of each component in by_component_, and one past the end
};

/// A feature as it was found: places on the mesh in order along it. Sureness 0..1.
struct FoundLine {
  std::vector<mesh::MeshPoint> points;
  double sureness = 0;
};

}  // namespace penpose::portrait
