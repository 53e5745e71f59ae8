#pragma once

#include <string>
#include <vector>

#include "ui/app/notices.h"
#include "ui/app/session/editing_session.h"

namespace penpose::app {

/// Which controls lines and pulls may move, beside what the artist locked: only some, or all but some. It is a step of
/// the document (the others are locked), so that undo takes it back and sessions replay it; what was locked before
/// stays locked when it is lifted.
class Restriction {
 public:
  Restriction(EditingSession& editing, Notices& notices) : editing_(editing), notices_(notices) {}

  /// Only these controls may move from now on. `words`: what they are called ("brows"). One step of undo, also where
  /// another restriction was on.
  void only(const std::vector<std::string>& names, const std::string& words);
  /// All others may move.
  void without(const std::vector<std::string>& names, const std::string& words);
  /// All may move again but those that the artist locked.
  void lift();

  /// Says what is on, "Only brows"; empty: nothing is. A document whose controls are mostly locked, as one that was
  /// opened so, counts as restricted.
  [[nodiscard]] std::string words() const;
  /// These controls, and no others, may move.
  [[nodiscard]] bool is_only(const std::vector<std::string>& names) const;

  /// Another document was opened.
  void forget() { made_.clear(); }

 private:
  /// One that was made: undo and redo go back and forth between them.
  struct Made {
    std::string words;
    std::vector<std::string> locked;  ///< by it, ascending
  };
  /// Locks these, and those that the artist locked.
  void hold(const std::vector<std::string>& names, const std::string& words);
  /// The one that is on: most of what it locked is locked; null: none.
  [[nodiscard]] const Made* on() const;
  /// What the artist locked, ascending.
  [[nodiscard]] std::vector<std::string> own_locks() const;

  EditingSession& editing_;
  Notices& notices_;
  std::vector<Made> made_;  ///< the newest last
};

}  // namespace penpose::app
