#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/commands/command.h"
#include "core/document/document.h"
#include "core/poses/face_part.h"

namespace penpose::app {

/// Which part of a face a control is of.
using poses::FacePart;

/// Told by its name, as rigs call them in English; `all` where the name says nothing.
[[nodiscard]] FacePart part_of(std::string_view control);

/// What is to be taken of a keyed pose, or of an expression of the model.
struct PoseChoice {
  double time_s = -1;  ///< of its key; negative: none is chosen
  FacePart part = FacePart::all;
  bool mirrored = false;
  double amount = 1;
  std::optional<std::size_t> expression = {};  ///< of the model, instead of a key

  [[nodiscard]] bool chosen() const { return time_s >= 0 || expression; }
};

/// The values that bring the document's pose towards the keyed one, by the amount, in the part; of an expression its
/// targets alone. Empty where nothing changes or there is no such key or expression. `pairs`: side_pairs.h.
[[nodiscard]] document::SetParameters values_of_choice(const document::Document& document, const PoseChoice& choice,
                                                       const std::vector<std::size_t>& pairs);

/// The keys that stand in the library, by their numbers: all with a name, and those that were posed one by one. A take
/// is one thing: of keys of single controls that follow each other, the first and the last stand for all.
[[nodiscard]] std::vector<std::size_t> keys_shown(const document::Timeline& timeline);

}  // namespace penpose::app
