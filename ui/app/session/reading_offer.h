#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/app/session/editing_session.h"

namespace penpose::app {

/// What the other readings of the last line move, in words, the best first: "lips pucker +0.30", "without jaw opens".
/// Both sides that go alike are one. `words`: one a parameter. Empty: the last line has no others, or something else
/// came after it.
[[nodiscard]] std::vector<std::string> words_of_readings(const document::Document& document,
                                                         std::span<const document::ControlWords> words);

/// Other readings of the last line, "did you mean": one is shown on the face where the pen is over it, and becomes a
/// step when it is taken. The reading that it took the place of is then among them. The next step ends the offer.
class ReadingOffer {
 public:
  /// Call it for every frame. `quiet`: nothing is offered now.
  void follow(EditingSession& editing, bool quiet);
  [[nodiscard]] bool open() const { return !words_.empty(); }
  [[nodiscard]] const std::vector<std::string>& words() const { return words_; }
  /// How likely each is, per cent, rounded; one a word.
  [[nodiscard]] const std::vector<int>& percents() const { return percents_; }
  /// Whether the line moved nothing, though it asks for more than the hand's doubt.
  [[nodiscard]] bool nothing_moved() const { return nothing_moved_; }
  /// Shows one on the face; nothing: none.
  void show(EditingSession& editing, std::optional<std::size_t> which);
  /// Makes one a step, where there are so many.
  void take(EditingSession& editing, std::size_t which);

 private:
  std::vector<std::string> words_;
  std::vector<int> percents_;
  bool nothing_moved_ = false;
  std::optional<std::size_t> shown_;
  rig::Pose shown_pose_;
  std::optional<std::uint64_t> revision_;  ///< that words_ are of
};

}  // namespace penpose::app
