#pragma once

#include <string>

#include "core/base/state_hash.h"
#include "core/geometry/space.h"

namespace penpose::document {

/// A picture, the numbered pictures of a film, or a film that one animates after. The document knows of it where it
/// lies, which it is and where it stands; whoever shows it has its pictures.
struct ReferencePicture {
  std::string file;                ///< relative to the project where it lies beside or below it
  base::Hash128 content;           ///< of the bytes of the file, base::hash_bytes; of pictures the one that was named
  double offset_s = 0;             ///< the moment of the timeline at which it begins
  double opacity = 0.8;            ///< 0..1
  bool beside = false;             ///< a card on the window, and not behind the model
  geometry::ModelPoint middle{0};  ///< of what stands behind the model, where it faces whoever looks
  double height = 1;               ///< of the same, model units
  geometry::PxPoint card{0.02, 0.04};  ///< left and upper corner of a card, in shares of the free part of the window
  double card_height = 0.35;           ///< likewise
  friend bool operator==(const ReferencePicture&, const ReferencePicture&) = default;
};

/// The longest path, bytes.
inline constexpr std::size_t k_longest_reference_path = 4096;
/// The range of ReferencePicture::card_height.
inline constexpr double k_smallest_card = 0.05, k_largest_card = 1;

}  // namespace penpose::document
