#pragma once

#include <map>
#include <span>
#include <vector>

#include "core/portrait/line_system.h"

namespace penpose::portrait {

/// Labels with the pose that goes best with them.
struct Reading {
  std::vector<Label> labels;
  SparsePose pose;
  Placement placement;
  std::vector<double> proportions;
  double energy = 0;  ///< of the pose, and of lines of one curve
};

/// Reads the lines of one sheet.
class SheetReader {
 public:
  /// `lines`: of a sheet about as large as k_face_px. `still`: the face is at rest, nothing moves.
  SheetReader(const FaceView& face, std::span<const Trace> lines, bool still);

  [[nodiscard]] Reading read();
  /// Replaces what the model has at rest by what another sheet showed.
  LineSystem& system() { return system_; }

 private:
  struct Guess {
    std::vector<Label> labels;
    Placement placement;
    double cost = 0;
  };
  [[nodiscard]] Guess guess_from(Placement placement);
  [[nodiscard]] std::vector<Guess> guesses();
  [[nodiscard]] std::vector<Trace> on_face(const Placement& placement) const;
  /// The best pose for labels, lines sliding along curves as they are in the last pose.
  [[nodiscard]] Reading read_as(std::vector<Label> labels, std::span<const std::size_t> units);
  /// Labels anew beside the pose of a reading, again and again.
  [[nodiscard]] Reading settled(std::vector<Label> labels);
  /// Changes labels of single lines, and of two that change places, while that lowers the energy.
  [[nodiscard]] Reading improved(Reading reading);

  const FaceView& face_;
  std::span<const Trace> lines_;
  bool still_;
  Likeness first_;
  LineSystem system_;
  SparseSolver solver_;
};

}  // namespace penpose::portrait
