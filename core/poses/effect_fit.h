#pragma once

#include <optional>
#include <vector>

#include "core/poses/face_measure.h"

namespace penpose::poses {

/// What features that a pose and a face have in common should do: model units of the face, a move a place.
struct AskedMoves {
  std::vector<std::size_t> features;  ///< of the face
  std::vector<ModelVector> moves;     ///< k_places each
  [[nodiscard]] double size() const;  ///< root of the sum of squares
};
[[nodiscard]] AskedMoves asked_of(const FaceMeasure& face, const std::vector<FeatureMoves>& moves, FacePart part);

/// What a pose leaves of them, as a share of their size.
[[nodiscard]] double left_of(const FaceMeasure& face, const AskedMoves& asked, const rig::Pose& pose);

/// The values of a rig's own controls, from rest, whose moves are nearest to those asked for: least squares within the
/// ranges, that few controls do, linearised a few times along the way of each control. Others stay at rest. `part`: of
/// what the controls move.
[[nodiscard]] rig::Pose fit_effects(const FaceMeasure& face, const rig::Rig& rig, const AskedMoves& asked,
                                    FacePart part);

}  // namespace penpose::poses
