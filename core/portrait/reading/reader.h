#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/portrait/reading/line_system.h"

namespace penpose::portrait {

/// Labels with the pose that goes best with them.
struct Reading {
  std::vector<Label> labels;
  SparsePose pose;
  Placement placement;
  std::vector<double> proportions;
  double energy = 0;  ///< of the pose, and of lines of one curve
};

/// How the lines of a sheet were drawn, and what is known of them.
struct Sketching {
  Hand hand;
  bool in_view = false;                                    ///< over the face: the sheet is its own picture
  bool still = false;                                      ///< the face is at rest, nothing moves
  std::span<const std::optional<std::size_t>> given = {};  ///< one a line: its curve, or k_nothing; empty: none
};

/// Reads the lines of one sheet.
class SheetReader {
 public:
  /// `lines`: of a sheet about as large as k_face_px.
  SheetReader(const FaceView& face, std::span<const Trace> lines, const Sketching& sketching);

  SheetReader(const SheetReader&) = delete;
  SheetReader& operator=(const SheetReader&) = delete;

  [[nodiscard]] Reading read();
  /// From what another reader of the same lines found, with its stretches.
  [[nodiscard]] Reading read_from(const Reading& other, const Stretches& stretches);
  [[nodiscard]] const Stretches& stretches() const { return stretches_; }

 private:
  struct Guess {
    std::vector<Label> labels;
    Placement placement;
    double cost = 0;
  };
  [[nodiscard]] Guess guess_from(Placement placement, int rounds);
  /// What each line may be, given where the sheet lies; only what was said of it where something was.
  [[nodiscard]] std::vector<std::vector<Label>> candidates(const Likeness& likeness, std::span<const Trace> lines);
  [[nodiscard]] bool is_given(std::size_t line) const { return line < given_.size() && given_[line].has_value(); }
  [[nodiscard]] std::vector<Guess> guesses();
  [[nodiscard]] std::vector<Trace> on_face(const Placement& placement) const;
  /// Where only one border of the mouth's opening is drawn, the lips are shut and it is both.
  void join_shut_lips(std::vector<Label>& labels);
  /// The best pose for labels, lines sliding along curves as they are in the last pose.
  /// `least`: nothing is returned where the energy without more units is above this.
  [[nodiscard]] std::optional<Reading> read_as(std::vector<Label> labels, std::span<const std::size_t> units,
                                               double most);
  /// Labels anew beside the pose of a reading, again and again.
  [[nodiscard]] Reading settled(std::vector<Label> labels, const Placement& placement, double doubt);
  /// Doubt of a placement that was found before, of what is usual.
  [[nodiscard]] double doubt_of(const Placement& placement) const;
  /// Changes labels of single lines, and of two that change places, while that lowers the energy.
  [[nodiscard]] Reading improved(Reading reading);

  /// Finer ends for lines that are parts of curves, as they lie beside a reading.
  [[nodiscard]] std::vector<Label> fine(std::vector<Label> labels, const Reading& reading);

  const FaceView& face_;
  Stretches stretches_;
  std::span<const Trace> lines_;
  std::size_t trials_ = 0;  ///< of improved()
  Hand hand_;
  bool in_view_, still_;
  std::span<const std::optional<std::size_t>> given_;
  std::vector<double> apart_;  ///< distances between lines, px of the sheet
  Likeness first_;
  LineSystem system_;
  SparseSolver solver_;
};

}  // namespace penpose::portrait
