#pragma once

#include <string>
#include <vector>

#include "core/io/tracks/point_table.h"

namespace penpose::io {

/// The rows of the face that is seen best: the greatest sum of confidences over frames that show it. Faces that are
/// never seen in the same frame are one that the tracker lost and found, and their rows are joined. A frame that has
/// rows of other faces alone becomes a row that is held, so that the clip keeps its length. Frames are told apart by
/// their numbers, else by their times; where the rows have neither, the best face alone is read. Says in `notes` which
/// faces were joined and how many there are.
[[nodiscard]] std::vector<TrackRow> rows_of_best_face(std::vector<FaceRow> rows, std::vector<std::string>& notes);

}  // namespace penpose::io
