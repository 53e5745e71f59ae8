#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/intent/line/overshoot.h"
#include "core/intent/line/sliding.h"
#include "core/intent/model/whole_model.h"
#include "core/intent/problem.h"
#include "core/intent/reading/quadratic.h"
#include "core/intent/reading/selection.h"
#include "core/joints/turn.h"
#include "core/posing/curve_system.h"

namespace penpose::intent {

/// nu of the energy: beyond this many squares of doubt a curve is out of reach and counts by its logarithm.
inline constexpr double k_reach = 150.0;

/// Evaluates and linearises a problem near a pose: the part that all ways of solving it share. Variables are the free
/// parameters that move a curve, as changes from the start, in units of their ranges. The rig, the whole model and the
/// problem must outlive it. One object for each thread.
class Reader {
 public:
  /// Precondition: check_problem passed.
  Reader(const rig::Rig& rig, const WholeModel& whole, const IntentProblem& problem);

  [[nodiscard]] const Choices& choices() const { return choices_; }
  [[nodiscard]] const Costs& costs() const { return costs_; }
  [[nodiscard]] std::span<const std::size_t> parameters() const { return parameters_; }
  /// The joints that the strokes mean (chain_of), ascending.
  [[nodiscard]] std::span<const std::size_t> chain() const { return chain_; }
  [[nodiscard]] bool linear() const { return linear_; }
  [[nodiscard]] std::size_t curve_count() const { return blocks_.size(); }
  /// Units that each bend one joint of the chain within the picture, ascending; none where there are too many to choose
  /// from at once.
  [[nodiscard]] std::vector<std::size_t> all_bends() const;
  /// First guesses for lines that are shorter than their limbs: each joint of the chain, and the longest run of it,
  /// leaning towards the eye and away from it. Choice::costs: its prior cost, slightly higher away from the eye.
  [[nodiscard]] std::vector<Choice> leans_in_depth() const;
  /// Whether a choice turns a joint or run out of the picture plane.
  [[nodiscard]] bool leans(const Choice& choice) const;
  /// Only units of these joints may move; empty: all.
  void restrict_to(std::span<const std::size_t> joints);

  /// Lets values exceed their limits by this many ranges, to find what a line beyond them means; 0 turns that off.
  void stretch(double ranges);

  /// How drawn curve c is aligned; all of `alignments` are worth trying.
  [[nodiscard]] const std::vector<Alignment>& alignments(std::size_t c) const { return blocks_[c].alignments; }
  void align(std::size_t c, std::size_t which) { blocks_[c].aligned = which; }
  [[nodiscard]] std::size_t aligned(std::size_t c) const { return blocks_[c].aligned; }
  /// Whether drawn curve c's line shows where one of its ends should be (Overshoot).
  [[nodiscard]] bool ends_told(std::size_t c) const;
  /// The points of drawn curve c on its picture, at the start.
  [[nodiscard]] std::vector<PxPoint> seen_at_start(std::size_t c) const { return seen(blocks_[c], start_); }
  /// Replaces the line of drawn curve c. Precondition: at least two points, of positive length.
  void redraw(std::size_t c, std::span<const PxPoint> line, Alignment alignment);

  /// The choice that leads from the start to a pose, with pairs where both sides moved. Its energy is not set.
  /// Precondition: no chain.
  [[nodiscard]] Choice choice_of(const rig::Pose& pose) const;
  /// The pose of a choice: within all ranges.
  [[nodiscard]] rig::Pose pose_of(const Choice& choice) const;
  /// Sets up the quadratic form around a choice; `slide`: points slide to where they fit (not in the first round, when
  /// the curves are still apart); `only`: the variables in question; empty: all. Each curve is weighted by its last
  /// share (see weigh).
  void look(const Choice& at, bool slide, Quadratic& quadratic, std::span<const std::size_t> only = {});
  /// The energy of a choice at its true pose, with the matching of the last look. `costs`: those of its units.
  double energy(const Choice& choice, double costs);
  /// The energy without costs, of an image: R z - r and P z - p of the last look.
  [[nodiscard]] double energy_of_image(std::span<const double> image, std::size_t rows) const;
  /// How far each variable's whole range moves each drawn curve in its picture, root mean square, model units; one row
  /// a curve. Precondition: no chain.
  [[nodiscard]] std::vector<std::vector<double>> curve_displacements() const;
  /// Whether a choice moves drawn curve c by more than the line is off from where it was meant.
  bool takes_shape(std::size_t c, const Choice& choice);
  /// D of drawn curve c alone.
  double squares_of(std::size_t c, const Choice& choice);
  /// Gives all curves full weight again.
  void weigh_evenly();
  /// Lowers the weight of curves that are out of reach at a choice, from the next look on.
  void weigh(const Choice& choice);

  struct Left {
    std::vector<double> px, units;  ///< mean distance for each curve
    double sum = 0, longest = 0;    ///< model units
  };
  /// Distances of the points from their targets at a pose; with sliding.
  [[nodiscard]] Left left(const rig::Pose& pose);

 private:
  struct Block {
    std::size_t first = 0, count = 0;  ///< its points among all
    const DrawnCurve* drawn = nullptr;
    const KnownCurve* known = nullptr;
    std::optional<SlidingLine> line;
    std::vector<Alignment> alignments;
    std::size_t aligned = 0;
    double doubt = 1;            ///< px or model units
    std::vector<PxPoint> shown;  ///< of a drawn curve: where it was in the picture; empty where unused
    double share = 1;            ///< 1 / (1 + D / nu) of the last weigh
    std::size_t row = 0, rows = 0, slide = 0;
    std::array<Overshoot, 2> overshoots{};  ///< of a drawn curve as last looked at
    Matching matching;
    ModeMatrix factor{};  ///< Cholesky factor of the sliding cost
  };
  /// For faces only: the joints determine where a limb ends.
  [[nodiscard]] bool overshoots_tell() const { return chain_.empty(); }
  /// Of a drawn curve, as it is aligned, px.
  [[nodiscard]] static double doubt_of(const Block& block);
  /// Raises the doubt of a line with its distance from where the curve was seen.
  void doubt_what_is_far(Block& block, std::span<const PxPoint> line) const;
  void look_at_drawn(Block& block, Quadratic& quadratic, std::span<const double> at, bool slide,
                     std::span<const std::size_t> variables);
  /// Finds which ends of a drawn curve follow from the part of the line beyond them.
  void tell_ends(Block& block) const;
  [[nodiscard]] static double squares_of(const Overshoot& one, PxPoint end, double doubt);
  /// The contribution of a matched curve's overshoots to D.
  [[nodiscard]] double overshoot_squares(const Block& block, std::span<const ModelPoint> positions) const;
  void look_at_overshoots(Block& block, std::span<const PxPoint> px, Quadratic& quadratic, std::span<const double> at,
                          std::span<const std::size_t> variables);
  void look_at_known(Block& block, Quadratic& quadratic, std::span<const double> at,
                     std::span<const std::size_t> variables);
  [[nodiscard]] std::vector<PxPoint> seen(const Block& block, std::span<const ModelPoint> positions) const;
  void make_columns(const rig::Pose& pose, std::span<const double> at, std::span<const std::size_t> variables);
  void make_units();
  /// All points at a pose, those of drawn curves where the pen drew them.
  void place(const rig::Pose& pose, std::vector<ModelPoint>& out);
  /// How far each parameter moves the surroundings of each drawn or known curve relative to it, root mean square, model
  /// units.
  [[nodiscard]] std::vector<std::vector<double>> surrounding_displacements() const;
  /// The connected pieces of the surface that a reference lies on, ascending.
  [[nodiscard]] std::vector<std::uint32_t> pieces_of(std::span<const posing::CurvePoint> reference) const;
  /// Fills the ratios and curve_displacements_.
  void measure_side_effects();
  /// The cost of a control for moving other parts farther than the drawn curves.
  [[nodiscard]] double side_effect_cost(std::size_t variable) const;
  // Turns of joints about their own axes (reader_joints.cpp).
  void find_chain();
  void make_turns();
  void make_runs();
  void make_run_units();
  void add_turn(std::size_t variable);
  void add_turn_units(std::size_t first, std::size_t count, bool planar, double across);
  void make_turn_columns(const rig::Pose& pose, std::span<const double> at, std::span<const std::size_t> variables);
  [[nodiscard]] std::vector<glm::dvec3> turned_by(std::span<const double> at) const;
  void turn_pose(std::span<const double> at, rig::Pose& pose) const;
  [[nodiscard]] std::size_t lean_count() const;
  void look_at_leans(Quadratic& quadratic, std::size_t row, std::span<const double> at);
  [[nodiscard]] double lean_cost(const Choice& choice) const;
  [[nodiscard]] std::optional<ModelVector> only_view() const;
  [[nodiscard]] bool swings_others(std::size_t joint) const;
  [[nodiscard]] double movement_about(std::size_t variable) const;
  /// D of a curve at positions of all points, before the logarithm.
  [[nodiscard]] double squares(const Block& block, std::span<const ModelPoint> positions) const;

  /// A variable of a run of joints: the turns for one unit of it.
  struct RunVariable {
    struct Part {
      std::size_t variable;  ///< of a turn
      double by;
    };
    std::vector<Part> parts;
    double movement = 0;
    std::size_t joints = 0;
    bool planar = false;  ///< of its run
    double across = 1;
  };
  [[nodiscard]] std::size_t variable_count() const { return parameters_.size() + run_variables_.size(); }

  const rig::Rig& rig_;
  const WholeModel& whole_;
  const IntentProblem& problem_;
  Costs costs_;
  posing::CurveSystem system_;
  std::vector<Block> blocks_;
  std::vector<std::size_t> parameters_;
  std::vector<double> ranges_;
  std::vector<std::size_t> all_;  ///< every variable
  std::vector<std::size_t> chain_;
  std::vector<joints::Turn> turns_;
  std::vector<std::size_t> turn_of_;        ///< one a parameter's variable: its turn, or k_no_partner
  std::vector<std::size_t> axis_of_;        ///< of the turn
  std::vector<RunVariable> run_variables_;  ///< their numbers come after those of the parameters; three a run
  Choices choices_;
  std::vector<double> side_effect_ratios_;   ///< WholeModel::stride over curve_displacements_, at least 1
  std::vector<double> curve_displacements_;  ///< of the curve that a variable moves most, root mean square, model units
  std::vector<double> tangential_ratios_;    ///< displacement of that curve over its part across the curve, 1 to 10
  std::vector<double> surrounding_ratios_;   ///< surrounding displacement over curve_displacements_, at least 1
  bool linear_ = false;
  std::vector<ModelVector> columns_;  ///< one run of points a variable, for its whole range
  std::vector<ModelPoint> start_, positions_, moved_;
  /// Maps a point's displacement to its three rows; all zero where the point has no target.
  struct PointRows {
    ModelVector normal{0}, along{0}, ray{0};
    double root = 0;  ///< of the point's weight
  };
  std::vector<PointRows> rows_;
};

/// For a line that goes beyond the limits: finds the choice that would explain it without limits, then fits its units
/// within them. `within`: a choice at a limit, at which the reader looked last. Nothing unless the choice found has
/// fewer units than `within` and a lower energy. Adds to `evaluations`.
[[nodiscard]] std::optional<Choice> meant_without_limits(Reader& reader, Quadratic& quadratic, const Choice& within,
                                                         std::size_t most_units, std::size_t& evaluations);

}  // namespace penpose::intent
