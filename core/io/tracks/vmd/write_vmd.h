#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/document/model.h"

namespace penpose::io {

/// What write_vmd wrote.
struct VmdBytes {
  std::vector<std::uint8_t> bytes;
  std::vector<std::string> notes;  ///< what the format has no place for, one line each
};

/// A model's first animation, or its pose where it has none, as morph keys of MikuMikuDance: 30 frames a second, keys
/// where a line from key to key would leave a value by more than 0.0005. Names are the controls' own, as Shift-JIS, cut
/// to 15 bytes. Joints are left out. Errors: no blend shape or deformer, more than 1,000,000 frames.
[[nodiscard]] base::Result<VmdBytes> write_vmd(const document::Model& model);

}  // namespace penpose::io
