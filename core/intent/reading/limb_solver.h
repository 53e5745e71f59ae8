#pragma once

#include <optional>

#include "core/intent/reading/reader.h"
#include "core/intent/reading/reading.h"

namespace penpose::intent {

/// Finds the best reading of strokes along limbs, matching and choosing in turn.
class LimbSolver {
 public:
  LimbSolver(Reader& reader, const SolveOptions& options, SolveWorkspace::Buffers& buffers)
      : reader_(reader), options_(options), b_(buffers) {}

  /// Matching and choosing in turn, from nothing moved or from a first guess.
  Reading read(Choice choice = {});
  /// A choice of units, matched on its own, and its energy.
  Reading matched(Choice choice);
  /// Matches the curves at the pose of a reading.
  void match(const Reading& reading);
  /// Downhill simplex on the values of the last reading.
  void search(Reading& reading);

  std::size_t evaluations = 0;
  /// Readings must move something (Selection::forbid_nothing).
  bool something = false;
  /// The line whose shape readings must take on (Reader::takes_shape), if any.
  std::optional<std::size_t> shape;

 private:
  [[nodiscard]] bool takes_shape(const Reading& reading);
  [[nodiscard]] Choice near(const Choice& before, Choice after) const;

  Reader& reader_;
  const SolveOptions& options_;
  SolveWorkspace::Buffers& b_;
};

}  // namespace penpose::intent
