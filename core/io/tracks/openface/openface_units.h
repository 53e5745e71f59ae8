#pragma once

#include "core/animation/track.h"
#include "core/base/byte_reader.h"
#include "core/base/result.h"
#include "core/io/text/csv_reader.h"

namespace penpose::io {

/// Whether a table has a column of an action unit: AU12, AU12_r or AU12_c.
[[nodiscard]] bool has_units(const CsvReader& table);

/// OpenFace's CSV with action units and without points, as FeatureExtraction -aus writes it: AU12_r (0..5) or where
/// there is none AU12_c (0 or 1), as values "AU12" of 0..1; pose_Rx, pose_Ry, pose_Rz (radians; x right, y down, z
/// away) as HeadPitch, HeadYaw and HeadRoll about x, y up and z towards the camera. Times and faces as
/// read_openface_track has them; of several faces the one that comes first is read. Columns of whole names (AU12)
/// count to 5 where any value is above 1. Errors: no row with a face.
[[nodiscard]] base::Result<animation::WeightTrack> read_openface_units(base::Bytes bytes);

}  // namespace penpose::io
