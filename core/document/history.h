#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/document/commands/apply.h"
#include "core/document/commands/command.h"
#include "core/document/document.h"

namespace penpose::document {

/// A document with its history. Undo and redo go through all steps since it was opened. A step keeps only the parts of
/// the document that the command changed, so that its size depends neither on the mesh nor on how much is already
/// drawn.
class History {
 public:
  explicit History(Document document) : current_(std::move(document)) {}

  [[nodiscard]] const Document& document() const { return current_; }

  /// Applies a command and drops undone steps. On an error nothing changes.
  base::Status perform(const Command& command, ApplyWorkspace& work);
  /// Errors: nothing to undo or redo.
  base::Status undo();
  base::Status redo();

  [[nodiscard]] std::size_t undo_count() const { return done_.size(); }
  [[nodiscard]] std::size_t redo_count() const { return undone_.size(); }
  /// The name of the command that undo takes back, or redo brings back. Precondition: there is one.
  [[nodiscard]] std::string_view next_undo() const { return done_.back().command.name; }
  [[nodiscard]] std::string_view next_redo() const { return undone_.back().command.name; }
  /// What the command of any step is called: those that are done come first, those that redo would bring back after
  /// them. Precondition: step < undo_count() + redo_count().
  [[nodiscard]] Called called_step(std::size_t step) const {
    return step < done_.size() ? done_[step].command : undone_[undone_.size() - 1 - (step - done_.size())].command;
  }

 private:
  struct Step {
    Called command;  ///< strokes are not kept
    Document other;  ///< of `done_` the document before the command, of `undone_` the one after it
    // What `other` has in common with the document on the step's other side is not kept in it.
    std::size_t first_curves = 0;  ///< at the front of the list that are the same
    std::size_t last_curves = 0;   ///< and at its end
    Timeline timeline;             ///< that of `other`, without equal keys
    std::size_t first_keys = 0;
    std::size_t last_keys = 0;
    bool same_timeline = false;
    bool same_pose = false;
    bool same_locks = false;
    bool same_views = false;
    void take_out(const Document& neighbour);
    void put_back(const Document& neighbour);
  };
  /// Goes over the last step of one list, to what is on its other side.
  void cross(std::vector<Step>& from, std::vector<Step>& to);

  Document current_;
  std::vector<Step> done_;
  std::vector<Step> undone_;
};

}  // namespace penpose::document
