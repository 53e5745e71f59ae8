#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/document/document.h"
#include "core/geometry/bvh.h"
#include "core/portrait/feature_curve.h"
#include "core/portrait/silhouette.h"
#include "ui/render/ghosts/ghost_moments.h"

namespace penpose::render {

/// A line of the face at another moment, as far as the view shows it: of a feature, of a curve that was drawn, or else
/// a contour.
struct GhostLine {
  std::string feature;                     ///< empty: of none
  std::optional<document::CurveId> curve;  ///< nothing: none
  portrait::SurfaceLine on;                ///< where on the surface; at least two points
  std::vector<geometry::PxPoint> places;   ///< where in the view, one a point
  [[nodiscard]] bool is_contour() const { return feature.empty() && !curve; }
};

/// The face as it is at another moment.
struct Ghost {
  GhostMoment moment;
  rig::Pose pose;
  std::vector<glm::vec3> positions;  ///< of all vertices
  std::vector<GhostLine> lines;
};

/// From where, and beside which moment, ghosts are looked at.
struct GhostSight {
  const document::Document& document;
  std::span<const portrait::FeatureCurve> features;  ///< of the document's face
  document::View view;
  double time_s = 0;
  double rate = 24;  ///< frames a second
};

/// The ghosts of a document. What has not changed since the look before is kept: surfaces until keys or the pose of
/// their moment change, lines until the view does, too. While the view moves lines stay where they are on the surface;
/// those of the view are found once it rests.
class GhostFaces {
 public:
  void look_at(const GhostSight& sight, const GhostLook& look);
  /// Nothing is kept.
  void forget();

  /// Ascending in time.
  [[nodiscard]] std::span<const Ghost> ghosts() const { return ghosts_; }
  /// Grows with every look that found something else.
  [[nodiscard]] std::uint64_t number() const { return number_; }
  /// Whether lines are those of the view; else they will be with another look at the same one.
  [[nodiscard]] bool settled() const { return settled_; }
  /// Surfaces that were posed, and whose lines were found in a view, since the beginning.
  [[nodiscard]] std::uint64_t posed() const { return posed_; }
  [[nodiscard]] std::uint64_t traced() const { return traced_; }

 private:
  /// What moments and poses of ghosts come from.
  struct Source {
    std::shared_ptr<const document::Model> model;
    std::shared_ptr<const document::Timeline> timeline;
    rig::Pose pose;  ///< of the document
    double time_s = 0;
    double rate = 0;
    GhostLook look;
    friend bool operator==(const Source&, const Source&) = default;
  };
  void pose_all(const GhostSight& sight, const GhostLook& look);
  void follow_view(const geometry::Camera& camera);
  void trace(Ghost& ghost, const GhostSight& sight, const geometry::Camera& camera);

  Source source_;
  document::View view_;
  std::vector<std::shared_ptr<const document::PoseCurve>> curves_;
  std::size_t feature_count_ = 0;
  std::vector<Ghost> ghosts_;
  std::optional<geometry::TriangleBvh> tree_;
  bool settled_ = true;
  std::uint64_t number_ = 0;
  std::uint64_t posed_ = 0;
  std::uint64_t traced_ = 0;
};

}  // namespace penpose::render
