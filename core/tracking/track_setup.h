#pragma once

#include <string>
#include <vector>

#include "core/animation/animate_track.h"
#include "core/base/result.h"
#include "core/document/model.h"
#include "core/io/project/landmark_file.h"
#include "core/io/tracks/map_file.h"

namespace penpose::tracking {

/// Finds what a map names in the track and in the model: curves by name among `landmarks`, the model's own, and those
/// of heads that are known by their vertex numbers; controls by name without case and separators. A control list of
/// which the model has nothing frees all controls. Curves of a bundled map that the model lacks are left out, with a
/// note, as long as one is left. Errors (place: JSON pointer in the map): a name or a vertex that does not exist.
[[nodiscard]] base::Result<animation::TrackSetup> make_setup(const document::Model& model,
                                                             const animation::PointTrack& track, const io::MapFile& map,
                                                             const std::vector<io::VertexCurve>& landmarks,
                                                             std::vector<std::string>& notes);

/// The controls that the track's action units name by ARKit's names for what they do (AU12: mouthSmile), left and
/// right.
[[nodiscard]] std::vector<animation::UnitControl> unit_controls(const document::Model& model,
                                                                const animation::PointTrack& track);

}  // namespace penpose::tracking
