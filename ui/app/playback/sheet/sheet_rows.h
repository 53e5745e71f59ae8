#pragma once

#include <cstddef>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "core/document/document.h"
#include "core/document/words/control_words.h"
#include "ui/app/session/pose_library.h"

namespace penpose::app {

/// A row of the dope sheet: a control, or a group of them.
struct SheetRow {
  std::string name;   ///< under which it is found
  std::string shown;  ///< what stands there
  bool group = false;
  bool folded = false;
  std::vector<std::size_t> controls;  ///< one; of a group all that are in it
};

/// The rows of a document's keys: groups by the part of the face, and joints by
/// their limb, which is named by its first joint. Below each its controls unless it is folded.
/// Listed are controls with a key, unless they rest in all of them; `all`: those too. `parts` and `words`: one a
/// parameter.
[[nodiscard]] std::vector<SheetRow> sheet_rows(const document::Document& document, std::span<const FacePart> parts,
                                               std::span<const document::ControlWords> words,
                                               const std::set<std::string>& folded, bool all);

}  // namespace penpose::app
