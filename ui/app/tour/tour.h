#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/document/commands/command.h"
#include "ui/app/action.h"

namespace penpose::app {

/// One thing that a tour asks for: a command that the user's own hand gives, or an action that is none.
struct TourStep {
  std::string says;                         ///< what to do, in a sentence
  std::optional<document::Command> wanted;  ///< as the tour's session has it
  std::optional<Action> press;              ///< in its place
};

/// A session that waits for the user's hand.
struct Tour {
  std::string name;   ///< "pose"
  std::string title;  ///< "Pose a face"
  std::string model;  ///< what it is drawn on
  std::vector<TourStep> steps;
  std::string ends;  ///< what is said when all is done
};

/// The names of the tours, in the order in which they are offered.
inline constexpr std::array<std::string_view, 3> k_tours{"pose", "rig", "animate"};

/// The session of a tour, compiled into the program; empty: there is none of that name. Its source file is made by
/// CMake of ui/app/tours.
[[nodiscard]] std::string_view tour_session(std::string_view name);

/// Reads a session as a tour: each of its commands is a step, and comment lines say what is said. "# tour says TEXT"
/// stands before a command, "# tour press ACTION TEXT" is a step of its own, "# tour title TEXT" and "# tour ends TEXT"
/// stand anywhere. Errors: a line that is none of a session, a command of which nothing is said, no model, no steps.
[[nodiscard]] base::Result<Tour> read_tour(std::string_view name, std::string_view session);

/// "tour:pose", by which a tour is opened as a file is; nothing for any other path.
[[nodiscard]] std::optional<std::string> tour_of_path(std::string_view path);

}  // namespace penpose::app
