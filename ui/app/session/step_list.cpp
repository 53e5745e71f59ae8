#include "ui/app/session/step_list.h"

#include <array>
#include <utility>

namespace penpose::app {
namespace {

using document::History;

constexpr std::array<std::pair<std::string_view, std::string_view>, 44> k_texts{{
    {"set_parameters", "Set a control"},
    {"reset_parameters", "Back to rest"},
    {"lock_parameters", "Lock or free"},
    {"suggest_rest", "Take the suggestion"},
    {"draw_reference", "Draw a feature"},
    {"place_curve", "Place a feature"},
    {"place_target", "Place its target"},
    {"draw_target", "Draw where it goes"},
    {"oversketch_target", "Draw over a target"},
    {"drag_target", "Move a target"},
    {"pull_target", "Pull at a target"},
    {"draw_constraint", "Hold a line"},
    {"pin", "Pin a point"},
    {"keep_curve", "Keep a line"},
    {"delete_curve", "Delete a line"},
    {"erase_curves", "Erase"},
    {"clear_curves", "Clear all lines"},
    {"solve_pose", "Solve again"},
    {"set_pressure_weighting", "Pressure counts, or not"},
    {"set_hand", "How steady the hand is"},
    {"name_curve", "Name a line"},
    {"delete_named_curve", "Forget a named line"},
    {"begin_deformer", "Begin a control"},
    {"begin_correction", "Begin a correction"},
    {"delete_correction", "Delete a correction"},
    {"take_region", "Choose the region"},
    {"draw_between", "Draw another target"},
    {"delete_between", "Forget another target"},
    {"pull_between", "Pull at a control's target"},
    {"sketch_curve", "Sketch a line"},
    {"cancel_deformer", "Give up a control"},
    {"redraw_curve", "Draw a control's line again"},
    {"change_deformer", "Change a control"},
    {"mirror_deformer", "Mirror a control"},
    {"rename_deformer", "Rename a control"},
    {"delete_deformer", "Delete a control"},
    {"move_deformer", "Move a control in the list"},
    {"set_key", "Key the pose"},
    {"key_poses", "Perform"},
    {"delete_key", "Delete a key"},
    {"move_key", "Move a key"},
    {"set_key_interpolation", "Smooth or linear"},
    {"save_view", "Keep a view"},
    {"delete_view", "Forget a view"},
}};

bool moves_in_time(std::string_view command) { return command == "go_to_time"; }

}  // namespace

void JoinedCommands::performed(std::size_t command, bool joined) {
  joined_.erase(joined_.lower_bound(command), joined_.end());
  if (joined) joined_.insert(command);
}

std::string_view step_text(std::string_view command) {
  for (const auto& [name, text] : k_texts) {
    if (name == command) return text;
  }
  return command;
}

std::vector<ListedStep> listed_steps(const History& history, const JoinedCommands& joined) {
  std::vector<ListedStep> steps;
  const std::size_t count = history.undo_count() + history.redo_count();
  for (std::size_t i = 0; i < count; ++i) {
    if (moves_in_time(history.name_of_step(i))) continue;
    if (joined.holds(i) && !steps.empty()) {
      steps.back().end = i + 1;
    } else {
      steps.push_back({std::string(step_text(history.name_of_step(i))), i + 1, false});
    }
    steps.back().undone = steps.back().end > history.undo_count();
  }
  return steps;
}

std::size_t commands_to_undo(const History& history, const JoinedCommands& joined) {
  std::size_t at = history.undo_count();
  while (at > 0 && (moves_in_time(history.name_of_step(at - 1)) || joined.holds(at - 1))) --at;
  return at == 0 ? 0 : history.undo_count() - (at - 1);
}

std::size_t commands_to_redo(const History& history, const JoinedCommands& joined) {
  const std::size_t done = history.undo_count();
  const std::size_t count = done + history.redo_count();
  std::size_t at = done;
  while (at < count && moves_in_time(history.name_of_step(at))) ++at;
  if (at == count) return 0;
  ++at;
  // What belongs to it, with the moves in time before that.
  for (std::size_t next = at; next < count; ++next) {
    if (joined.holds(next)) at = next + 1;
    if (!joined.holds(next) && !moves_in_time(history.name_of_step(next))) break;
  }
  return at - done;
}

}  // namespace penpose::app
