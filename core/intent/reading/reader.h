#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/intent/choosing/quadratic.h"
#include "core/intent/choosing/selection.h"
#include "core/intent/line/overshoot.h"
#include "core/intent/line/sliding.h"
#include "core/intent/model/whole_model.h"
#include "core/intent/problem.h"
#include "core/intent/reading/doubt.h"
#include "core/intent/reading/reading_costs.h"
#include "core/joints/turn.h"
#include "core/posing/curve_system.h"

namespace penpose::intent {

/// nu of the energy: beyond this many squares of doubt a curve is out of reach and counts by its logarithm.
inline constexpr double k_reach = 150.0;

/// Evaluates and linearises a problem near a pose: the part that all ways of solving it share. Variables are the free
/// parameters that move a curve, as changes from the start, in units of their ranges. The rig, the whole model and the
/// problem must outlive it. One object for each thread.
class Reader final : public Relations {
 public:
  /// Precondition: check_problem passed. Where nothing but joints that carry more than was drawn could follow the
  /// lines, those joints are meant, whatever the lines span (Weights::follows).
  [[nodiscard]] static Reader of(const rig::Rig& rig, const WholeModel& whole, const IntentProblem& problem,
                                 const inference::Weights& weights = inference::learned_weights());
  Reader(const rig::Rig& rig, const WholeModel& whole, const IntentProblem& problem, const inference::Weights& weights,
         bool any_span = false);

  [[nodiscard]] const Choices& choices() const { return choices_; }
  [[nodiscard]] const Costs& costs() const { return costs_; }
  [[nodiscard]] std::span<const std::size_t> parameters() const { return parameters_; }
  /// The joints that the strokes mean (chain_of), ascending.
  [[nodiscard]] std::span<const std::size_t> chain() const { return chain_; }
  [[nodiscard]] bool linear() const { return linear_; }
  /// Whether the strokes mean a limb, by the joints that they span; otherwise a face, or what is like one.
  [[nodiscard]] bool limb() const { return !chain_.empty(); }
  /// Of a face: leaves out, or takes back, the joints that carry much more than what was drawn.
  void leave_carriers(bool out);
  [[nodiscard]] bool leaves_carriers() const { return !carriers_.empty(); }
  /// Of a face: once it is known which controls are meant, their values follow the lines alone.
  void settle(bool settled);
  /// Returns the weight of the squares of shares.
  [[nodiscard]] double stiffness(bool settled) const;
  /// Of a face: the energy's scale, and what choices cost.
  [[nodiscard]] const Doubt& doubt() const { return doubt_; }
  [[nodiscard]] ReadingCosts reading_costs() const { return {choices_, weights_, *this, asked_}; }
  [[nodiscard]] const inference::Weights& weights() const { return weights_; }
  [[nodiscard]] bool is_joint(std::size_t variable) const override { return turns(variable); }
  /// Returns how differently two poses move the model from the start: the root mean square of their difference over
  /// that of the pose that moves it more.
  [[nodiscard]] double unlikeness(const rig::Pose& a, const rig::Pose& b) const;
  [[nodiscard]] double likeness(std::size_t a, std::size_t b) const override { return relation(a, b).likeness; }
  [[nodiscard]] double overlap(std::size_t a, std::size_t b) const override { return relation(a, b).overlap; }
  [[nodiscard]] bool moves_group(std::size_t variable, std::size_t group) const override {
    return moved_groups_[parameter_of(variable)][group];
  }
  /// Whether a variable is a joint's.
  [[nodiscard]] bool turns(std::size_t variable) const {
    return variable >= parameters_.size() || whole_.joint[parameters_[variable]] != k_no_partner;
  }
  [[nodiscard]] std::size_t line_count() const { return problem_.drawn.size(); }
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

  /// How drawn curve c is aligned; all of `alignments` are worth trying.
  [[nodiscard]] const std::vector<Alignment>& alignments(std::size_t c) const { return blocks_[c].alignments; }
  void align(std::size_t c, std::size_t which) { blocks_[c].aligned = which; }
  [[nodiscard]] std::size_t aligned(std::size_t c) const { return blocks_[c].aligned; }
  /// Whether drawn curve c's line shows where one of its ends should be (Overshoot).
  [[nodiscard]] bool ends_told(std::size_t c) const;
  /// The points of drawn curve c on its picture, at the start.
  [[nodiscard]] std::vector<PxPoint> seen_at_start(std::size_t c) const { return seen(blocks_[c], start_); }
  /// How far the farther end of drawn curve c's line lies from the curve at the start, px.
  [[nodiscard]] double beyond_at_start(std::size_t c) const;
  /// Replaces the line of drawn curve c. Precondition: at least two points, of positive length.
  void redraw(std::size_t c, std::span<const PxPoint> line, Alignment alignment);

  /// Of a face: the choice that leads from the start to a pose, with pairs where both sides moved; joints by what they
  /// turn, not by their values. Its energy is not set.
  [[nodiscard]] Choice choice_of(const rig::Pose& pose) const;
  /// Matches all curves at a pose and returns the energy there, without costs.
  double energy_at(const rig::Pose& pose);
  /// The pose of a choice: within all ranges.
  [[nodiscard]] rig::Pose pose_of(const Choice& choice) const;
  /// Sets up the quadratic form around a choice; `slide`: points slide to where they fit (not in the first round, when
  /// the curves are still apart); `only`: the variables in question; empty: all. Each curve is weighted by its last
  /// share (see weigh).
  void look(const Choice& at, bool slide, Quadratic& quadratic, std::span<const std::size_t> only = {});
  /// The energy of a choice at its true pose, with the matching of the last look. `costs`: those of its units.
  double energy(const Choice& choice, double costs);
  /// The same, matched there.
  double matched_energy(const Choice& choice, double costs);
  /// Returns the terms of the energy of a choice on a face, with the lines matched there.
  inference::Terms terms_of(const Choice& choice);
  /// The energy without costs, of an image: R z - r and P z - p of the last look.
  [[nodiscard]] double energy_of_image(std::span<const double> image, std::size_t rows) const;
  /// How far each variable's whole range moves each drawn curve in its picture, root mean square, model units; one row
  /// a curve. Precondition: no chain.
  [[nodiscard]] std::vector<std::vector<double>> curve_displacements() const;
  /// Whether a choice moves drawn curve c by more than the line is off from where it was meant.
  bool takes_shape(std::size_t c, const Choice& choice);
  /// D of drawn curve c alone, as last matched.
  double squares_of(std::size_t c, const Choice& choice);
  double squares_at(std::size_t c, const rig::Pose& pose);
  /// D of each drawn and known curve, matched at a choice.
  std::vector<double> squares_left(const Choice& choice);
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
    double doubt = 1;  ///< px or model units
    double share = 1;  ///< 1 / (1 + D / nu) of the last weigh
    std::size_t row = 0, rows = 0, slide = 0;
    std::array<Overshoot, 2> overshoots{};  ///< of a drawn curve as last looked at
    Matching matching;
    ModeMatrix factor{};  ///< Cholesky factor of the sliding cost
  };
  /// For faces only: the joints determine where a limb ends.
  [[nodiscard]] bool overshoots_tell() const { return chain_.empty(); }
  /// Of a drawn curve, as it is aligned, px.
  [[nodiscard]] static double doubt_of(const Block& block);
  /// What the line does not touch has no target on it.
  static void leave_still(const Block& block, Matching& m);
  /// Matches a drawn curve seen there.
  void match(Block& block, std::span<const PxPoint> px, bool slide) const;
  [[nodiscard]] double energy_as_placed() const;
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
  /// Of a face, where shapes act in a linear way while joints stay; made again only where joints went on.
  [[nodiscard]] bool make_face_columns(const rig::Pose& pose, std::span<const double> at,
                                       std::span<const std::size_t> variables);
  /// Columns of variables that are no turns, as differences.
  void make_differences(const rig::Pose& pose, std::span<const std::size_t> variables);
  void fill_column(std::size_t j, const posing::Residuals& values);
  void make_units();
  /// All points at a pose, those of drawn curves where the pen drew them.
  void place(const rig::Pose& pose, std::vector<ModelPoint>& out);
  /// Fills the ratios and curve_displacements_.
  void measure_side_effects();
  /// The cost of a control for moving other parts farther than the drawn curves.
  [[nodiscard]] double side_effect_cost(std::size_t variable) const;
  // Faces (reader_fields.cpp).
  /// Returns whether anything but such joints can follow the lines.
  [[nodiscard]] bool others_follow() const;
  /// Returns whether most of what shapes do happens on what a joint carries.
  [[nodiscard]] bool bears_face(std::size_t joint) const;
  /// Counts what joints carry from the joint that carries least, if all that can follow the lines carry about as much
  /// and no shape does anything on a joint: then a line can mean nothing else.
  void forgive_carriers();
  /// What a variable does beside what was drawn.
  struct Field {
    std::vector<ModelVector> near;           ///< at the samples near the drawn curves, for its whole range
    std::vector<double> ways;                ///< their lengths
    double near_square = 0, far_square = 0;  ///< sums of squares there and elsewhere
    double near_way = 0, distant_way = 0;    ///< the largest there, and far from the curves
    double mirrored_square = 0;              ///< near the mirror image of the curves alone
    double turn = 0;                         ///< of a piece without lines, the most
    double scattered_way = 0;                ///< the largest at places apart from those near the curves
    double usual_way = 0;                    ///< of the control, model units
  };
  struct Relation {
    double likeness = 0, overlap = 0;
  };
  /// Of two variables; measured once.
  [[nodiscard]] const Relation& relation(std::size_t a, std::size_t b) const;
  [[nodiscard]] std::vector<ModelPoint> at_rest(std::span<const posing::CurvePoint> reference) const;
  /// Whether a curve is long enough to speak for what its joints carry: a line along a limb does, a brow does not speak
  /// for the head.
  [[nodiscard]] bool spans(std::span<const posing::CurvePoint> reference, std::span<const std::size_t> chain) const;
  void group_curves();
  /// Returns the samples that are nearer to a drawn or known curve, or to its mirror image, than a share of its extent,
  /// ascending.
  [[nodiscard]] std::vector<std::uint32_t> samples_within(double share, bool mirrored = false) const;
  void measure_fields();
  /// Returns the pieces of the mesh that carry lines, ascending.
  [[nodiscard]] std::vector<std::uint32_t> drawn_pieces() const;
  void measure_asked();
  /// Whether each parameter moves a curve of each group by at least k_tells of what anything moves it.
  void measure_groups();
  /// Whether a variable turns that joint.
  [[nodiscard]] bool turns_joint(std::size_t variable, std::size_t turn) const;
  /// Whether a unit is a joint that carries much more than what was drawn.
  [[nodiscard]] bool carries_more(const Unit& unit) const;
  // Both sides of a face (reader_symmetry.cpp).
  /// Pairs the points of drawn curves with their mirror images about the model's middle, and finds how far the lines
  /// ask for the same on both sides.
  void measure_symmetry();
  /// The cosine of ways, one a point of the drawn curves, with their mirror image.
  [[nodiscard]] double likeness_to_image(std::span<const ModelVector> ways) const;
  /// Of a unit that does on one side what lines ask for on both.
  [[nodiscard]] double asymmetry_of(const Unit& unit) const;
  /// Sets the terms and the charge of a unit on a face.
  void charge_face(Unit& unit, bool by_axes = false) const;
  /// The first parameter that moves with a variable, as a number of parameters().
  [[nodiscard]] std::size_t parameter_of(std::size_t variable) const;
  void make_joint_pairs();
  void add_joint_pair(std::size_t first);
  /// Curves that tell of controls: all but those that have to stay.
  [[nodiscard]] std::size_t told_count() const { return problem_.drawn.size() + problem_.known.size(); }
  /// How far a line lies from a curve, root mean square over its points to the nearest place of the curve, px.
  [[nodiscard]] static double way_across(std::span<const PxPoint> curve, std::span<const PxPoint> line);
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
  std::vector<KnownCurve> still_;  ///< what corrections do not touch
  bool any_span_ = false;          ///< a line need not span what its joints carry
  Costs costs_;
  const inference::Weights& weights_;
  Doubt doubt_;
  std::vector<Field> fields_;                               ///< one a variable
  std::vector<Unit> carriers_;                              ///< left out of choices_
  mutable std::vector<std::optional<Relation>> relations_;  ///< of pairs, as far as they were asked for
  std::vector<std::size_t> images_;      ///< of each point of drawn curves, or k_no_partner; empty: not from the front
  std::vector<double> shares_at_start_;  ///< of ranges, from rest, one a parameter of the rig; empty: all at rest
  double usual_way_ = 0;                 ///< of the shape that moves most of what was drawn, model units
  double symmetry_ = 0;                  ///< of what the lines ask for, 0 to 1
  std::vector<double> asked_;            ///< one a group that tells of controls
  std::vector<std::vector<bool>> moved_groups_;  ///< one a parameter: whether it moves each of them
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
  bool linear_ = false;
  rig::Pose columns_at_;              ///< of a face: the pose at which its columns were made; empty: none
  std::vector<ModelVector> columns_;  ///< one run of points a variable, for its whole range
  std::vector<ModelPoint> start_, positions_, moved_;
  /// Maps a point's displacement to its three rows; all zero where the point has no target.
  struct PointRows {
    ModelVector normal{0}, along{0}, ray{0};
    double root = 0;  ///< of the point's weight
  };
  std::vector<PointRows> rows_;
};

}  // namespace penpose::intent
