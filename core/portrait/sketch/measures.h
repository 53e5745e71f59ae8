#pragma once

#include <array>
#include <optional>

#include "core/portrait/sketch/face_layout.h"

namespace penpose::portrait {

/// The measures of a drawn brow. Lengths are in distances of the eyes.
struct BrowMeasure {
  double height = 0;  ///< of its middle over the middle of the eyes
  double tilt = 0;    ///< rise from its inner to its outer end, of its width: below 0, the inner end is the higher one
  double bend = 0;    ///< by how much its middle is above its ends, of its width
};

enum class EyeKind : unsigned char {
  open,  ///< between two lids
  line,  ///< one line: shut, or a dash that stands for an eye
  dot    ///< a dot or a dash upright
};

struct EyeMeasure {
  EyeKind kind = EyeKind::open;
  double opening = 0;  ///< from lid to lid, of its width; 0 of lines and dots
  double bend = 0;     ///< of a line: by how much its middle is above its ends, of its width
  std::optional<double>
      covered;  ///< by the upper lid: the share of the iris, or of the whole eye; below 0, white shows
  double width = 0;
  double arched = 0.5;  ///< the share of the opening that lies above its corners
  double top = 0;       ///< of all that is drawn of it, above the middle of the eyes
};

struct MouthMeasure {
  double width = 0;
  double relative_width = 0;            ///< for the size of the face (FaceLayout::scale)
  double gap = 0;                       ///< between the lips, of the width
  std::array<double, 2> corners{0, 0};  ///< height of the corners over the middle of the lips, of the width: at the
                                        ///< left of the picture, at the right
  std::size_t lines = 1;                ///< one above the other
  bool shut = true;                     ///< one line, or lips with a line between them
  bool queasy = false;                  ///< wavy, or with a tongue
  double upper = 0;                     ///< the middle of the upper border over the middle of the mouth, of the width
};

/// The measures of a drawn face. A part that was not drawn has none. Arrays hold the left of the picture first, which
/// is the right of the face.
struct FaceMeasures {
  std::array<std::optional<BrowMeasure>, 2> brows;
  std::array<std::optional<EyeMeasure>, 2> eyes;
  std::optional<MouthMeasure> mouth;
  std::array<bool, 2> wrinkled{false, false};  ///< lines beside the nose, or from it to the mouth
};

[[nodiscard]] FaceMeasures measure(const FaceLayout& layout);

/// Returns whether a posed face contradicts a drawing, whatever its proportions: its brows tilt the other way, its lips
/// are apart where they were drawn shut, or its lips run through each other. `rest` is the same face at rest.
[[nodiscard]] bool contradicts(const FaceMeasures& drawn, const FaceMeasures& posed, const FaceMeasures& rest);

}  // namespace penpose::portrait
