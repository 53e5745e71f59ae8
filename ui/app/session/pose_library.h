#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/commands/command.h"
#include "core/document/document.h"

namespace penpose::app {

/// Which part of a face a control is of.
enum class FacePart : std::uint8_t { all, brows, eyes, mouth };

/// Told by its name, as rigs call them in English; `all` where the name says nothing.
[[nodiscard]] FacePart part_of(std::string_view control);

/// What is to be taken of a keyed pose.
struct PoseChoice {
  double time_s = -1;  ///< of its key; negative: none is chosen
  FacePart part = FacePart::all;
  bool mirrored = false;
  double amount = 1;
};

/// The values that bring the document's pose towards the keyed one, by the amount, in the part; empty where nothing
/// changes or there is no such key. `pairs`: side_pairs.h.
[[nodiscard]] document::SetParameters values_of_choice(const document::Document& document, const PoseChoice& choice,
                                                       const std::vector<std::size_t>& pairs);

}  // namespace penpose::app
