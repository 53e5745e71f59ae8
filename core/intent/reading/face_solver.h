#pragma once

#include <vector>

#include "core/intent/reading/reader.h"
#include "core/intent/reading/reading.h"

namespace penpose::intent {

class RobustSelection;

/// Finds the best reading of lines on a face, matching and choosing in turn (inference::Weights, Doubt).
class FaceSolver {
 public:
  FaceSolver(Reader& reader, const SolveOptions& options, SolveWorkspace::Buffers& buffers)
      : reader_(reader), options_(options), b_(buffers) {}

  /// Over the ways in which single lines may be aligned; the reader keeps the best one's.
  Reading read();
  /// Returns at most `count` other readings, the likeliest first. They move other controls than `taken` and than each
  /// other, and look different. Their values follow the lines alone, by least squares. `taken` is the reading as it was
  /// before settle; `probability` receives its probability. If `taken` moves nothing, the best readings that move
  /// something are returned, however unlikely they are. Call it last.
  [[nodiscard]] std::vector<OtherReading> others(const Reading& taken, std::size_t count, double& probability);
  /// Lets the values of a reading follow the lines alone: least squares, and downhill simplex on the energy itself.
  void settle(Reading& reading);

  /// Returns each reading that the solver matched, in any alignment, once, the best first. Call it before settle.
  [[nodiscard]] std::vector<Reading> all() const;
  /// Matches a choice of units with the lines as they are aligned, and returns it with its energy.
  Reading matched(Choice choice);
  /// Aligns the lines as a reading does.
  void align_as(const Reading& reading);

  std::size_t evaluations = 0;

 private:
  /// As aligned. Joints that carry much more than what was drawn are thought of where nothing else goes some way.
  Reading read_aligned();
  Reading read_choices();
  /// What a reading could gain at most if drawn curve c were met by nothing that costs anything.
  double most_to_gain(const Reading& reading, std::size_t c);
  /// The energy of a quick reading with drawn curve c aligned anew and the others read as before.
  double first_look(const Choice& choice, std::size_t c);
  /// The best choices of a selection that leave out a unit of one, and of each other.
  [[nodiscard]] std::vector<Choice> exchanges(const RobustSelection& selection, const Choice& from) const;
  /// Whether a choice leaves clearly less than what was asked.
  [[nodiscard]] bool goes_some_way(const Choice& choice);
  /// Whether it leaves less than this share of the squares of a line.
  [[nodiscard]] bool leaves_less(const Choice& choice, double share);
  /// Angles go a part of their range in one round; shapes all of it.
  [[nodiscard]] Choice near(const Choice& before, Choice after) const;

  Reader& reader_;
  const SolveOptions& options_;
  std::vector<Reading> matched_;  ///< all of the alignment that was read last; of the best one once all were read
  std::vector<Reading> all_;      ///< of every alignment
  SolveWorkspace::Buffers& b_;
};

}  // namespace penpose::intent
