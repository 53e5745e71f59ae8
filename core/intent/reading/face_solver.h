#pragma once

#include <vector>

#include "core/intent/reading/reader.h"
#include "core/intent/reading/reading.h"

namespace penpose::intent {

/// Finds the best reading of lines on a face, matching and choosing in turn (FaceCosts, Doubt).
class FaceSolver {
 public:
  FaceSolver(Reader& reader, const SolveOptions& options, SolveWorkspace::Buffers& buffers)
      : reader_(reader), options_(options), b_(buffers) {}

  /// Over the ways in which single lines may be aligned; the reader keeps the best one's.
  Reading read();
  /// Lets the values of a reading follow the lines alone: least squares, and downhill simplex on the energy itself.
  void settle(Reading& reading);

  std::size_t evaluations = 0;

 private:
  /// As aligned. Joints that carry much more than what was drawn are thought of where nothing else goes some way.
  Reading read_aligned();
  Reading read_choices();
  /// What a reading could gain at most if drawn curve c were met by nothing that costs anything.
  double most_to_gain(const Reading& reading, std::size_t c);
  /// The energy of a quick reading with drawn curve c aligned anew and the others read as before.
  double first_look(const Choice& choice, std::size_t c);
  /// Whether a choice leaves clearly less than what was asked.
  [[nodiscard]] bool goes_some_way(const Choice& choice);
  /// A choice of units, matched on its own, and its energy.
  Reading matched(Choice choice);
  /// Angles go a part of their range in one round; shapes all of it.
  [[nodiscard]] Choice trusted(const Choice& before, Choice after) const;

  Reader& reader_;
  const SolveOptions& options_;
  SolveWorkspace::Buffers& b_;
};

}  // namespace penpose::intent
