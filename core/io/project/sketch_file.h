#pragma once

#include <string>
#include <vector>

#include "core/articulation/corrections.h"
#include "core/base/byte_reader.h"
#include "core/base/result.h"

namespace penpose::io {

/// A file of strokes, as `penpose articulate --sketch` takes it: {"model", "viewport": [w, h], "deformers": [...]}. A
/// deformer has "name", "camera", "general", "specific", "target" and may have "reference", "mode", "surface",
/// "target_camera", and beyond what scripts rely on "reference_camera", "range": [minimum, maximum] and its own
/// "viewport", "paper", true where it is built as the paper says, "reach" ("through" or
/// "front") and "piece", what the first lasso takes, and "betweens": [{"value", "target", "camera"}, ...], its other
/// targets. "corrections" holds such objects, each with "drivers": [[CONTROL, VALUE], ...], the pose that it was drawn
/// at.
struct SketchFile {
  std::string model;  ///< the model that was drawn on; may be empty
  geometry::Viewport viewport;
  std::vector<articulation::Sketch> sketches;
  std::vector<std::string> skipped;  ///< JSON pointers of members that no reader knows
  std::vector<articulation::CorrectionSketch> corrections = {};
};

/// Members that are not known are skipped and listed. Errors (place: JSON pointer): no JSON, a key that is missing or
/// of another type, a camera that cannot be, a curve with too many or too far points, two deformers of one name.
[[nodiscard]] base::Result<SketchFile> read_sketch_file(base::Bytes bytes);

/// The JSON of a sketch file, one deformer a line; reads back as the same sketches.
[[nodiscard]] std::string write_sketch_file(const SketchFile& file);

}  // namespace penpose::io
