#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/document/document.h"

namespace penpose::document {

/// Keys of one moment that go to another one.
struct KeysMoved {
  std::size_t place = 0;              ///< in the timeline before
  std::vector<std::size_t> controls;  ///< whose keys go
  double to_s = 0;
};

/// Which mouths are spoken when keys have been moved; `document` has them where they were. A mouth goes along where the
/// keys of all controls do that mouths move, in place of one that is where it arrives. `copies`: it also stays. Null:
/// none is spoken.
[[nodiscard]] std::shared_ptr<const SpokenMouths> with_moved_keys(const Document& document,
                                                                  std::span<const KeysMoved> moved, bool copies);

}  // namespace penpose::document
