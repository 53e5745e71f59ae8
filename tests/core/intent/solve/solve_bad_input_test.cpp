// What cannot be met, or is no sensible wish, gives an error or a pose of plain numbers; never NaN, never for ever.
#include <cmath>
#include <gtest/gtest.h>

#include "core/intent/solve.h"
#include "tests/core/intent/face.h"

namespace penpose::intent {
namespace {

using tests::Face;
using tests::Line;

/// Solves, and expects plain numbers within the ranges.
rig::Pose plain(const Face& face, const IntentProblem& problem) {
  SolveWorkspace work;
  const auto solution = solve(*face.rig, measure_whole_model(*face.rig), problem, {}, work);
  if (!solution) {
    ADD_FAILURE() << solution.error().what;
    return rig::rest_pose(*face.rig);
  }
  for (std::size_t p = 0; p < solution->pose.size(); ++p) {
    EXPECT_GE(solution->pose[p], face.rig->parameters()[p].minimum) << p;
    EXPECT_LE(solution->pose[p], face.rig->parameters()[p].maximum) << p;
  }
  for (const double number : {solution->energy, solution->energy_start, solution->max_distance, solution->doubt_energy})
    EXPECT_TRUE(std::isfinite(number));
  for (const CurveLeft& left : solution->drawn) EXPECT_TRUE(std::isfinite(left.px) && std::isfinite(left.units));
  return solution->pose;
}

TEST(IntentBadInput, ATargetFarOffTheScreenMovesNothingElse) {
  const Face face = tests::usual_face();
  for (const double far : {5e3, 1e5, 9.9e5}) {
    plain(face, face.problem({face.drawn(Face::mouth(), {{far, far}, {far - 200, far}})}));
    plain(face, face.problem({face.drawn(Face::mouth(), {{-far, -far}, {far, far}})}));
  }
  SolveWorkspace work;
  const auto problem = face.problem({face.drawn(Face::mouth(), {{1e7, 0}, {1e7, 300}})});
  const auto refused = solve(*face.rig, measure_whole_model(*face.rig), problem, {}, work);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().what, "the target lies a million px away");
  EXPECT_EQ(refused.error().place, "curve 0");
}

TEST(IntentBadInput, ACurveOutOfReachDoesNotSpoilAnother) {
  const Face face = tests::usual_face();
  const rig::Pose answer = face.pose({{"browLeft", 0.7}});
  const DrawnCurve brow = face.drawn(Face::left_brow(), face.seen(Face::left_brow(), answer));
  Line away = face.seen(Face::mouth(), rig::rest_pose(*face.rig));
  for (PxPoint& p : away) p.x += 4000;
  const rig::Pose pose = plain(face, face.problem({brow, face.drawn(Face::mouth(), away)}));
  EXPECT_NEAR(pose[face.number("browLeft")], 0.7, 0.1);
}

TEST(IntentBadInput, AStrokeOfTwoPointsIsALine) {
  const Face face = tests::usual_face();
  const Line line = face.seen(Face::mouth(), face.pose({{"jawOpen", 0.6}}));
  const rig::Pose pose = plain(face, face.problem({face.drawn(Face::mouth(), {line.front(), line.back()})}));
  EXPECT_NEAR(pose[face.number("jawOpen")], 0.6, 0.1);
  for (const PxPoint to : {PxPoint{500, 501}, PxPoint{-4000, 3}})
    plain(face, face.problem({face.drawn(Face::mouth(), {{500, 500}, to})}));
}

TEST(IntentBadInput, ADotIsNoLine) {
  const Face face = tests::usual_face();
  SolveWorkspace work;
  const auto problem = face.problem({face.drawn(Face::mouth(), {{500, 500}, {500.3, 500}})});
  const auto solution = solve(*face.rig, measure_whole_model(*face.rig), problem, {}, work);
  ASSERT_FALSE(solution);
  EXPECT_EQ(solution.error().what, "the target has no length");
}

TEST(IntentBadInput, WeightsThatAreNoNumbersAreRefused) {
  const Face face = tests::usual_face();
  for (const double weight : {-1.0, std::nan(""), HUGE_VAL}) {
    auto problem = face.problem({face.drawn(Face::mouth(), face.seen(Face::mouth(), face.pose({{"jawOpen", 0.6}})))});
    problem.drawn[0].weights.assign(problem.drawn[0].reference.size(), weight);
    EXPECT_FALSE(check_problem(*face.rig, problem));
  }
}

TEST(IntentBadInput, AReferenceOfTwoPointsIsACurve) {
  const Face face = tests::usual_face();
  const auto two = std::vector{Face::mouth().front(), Face::mouth().back()};
  const rig::Pose pose = plain(face, face.problem({face.drawn(two, face.seen(two, face.pose({{"jawOpen", 0.6}})))}));
  EXPECT_NEAR(pose[face.number("jawOpen")], 0.6, 0.1);
}

TEST(IntentBadInput, ContradictoryTargetsOnOneCurveAgreeOnSomething) {
  const Face face = tests::usual_face();
  const DrawnCurve up = face.drawn(Face::left_brow(), face.seen(Face::left_brow(), face.pose({{"browLeft", 1}})));
  const DrawnCurve still = face.drawn(Face::left_brow(), face.seen(Face::left_brow(), face.pose({})));
  const rig::Pose pose = plain(face, face.problem({up, still, up}));
  EXPECT_EQ(pose[face.number("jawOpen")], 0);
  EXPECT_GT(pose[face.number("browLeft")], 0.3) << "two of three ask for it";
}

TEST(IntentBadInput, ACurveThatNothingMovesLeavesThePose) {
  Face face;
  face.bump("browLeft", -0.4, 0.5, {0, 0.15, 0}).ready();
  const Line line{{300, 700}, {700, 700}};
  const Solution solution = face.solve(face.problem({face.drawn(Face::mouth(), line)}));
  EXPECT_TRUE(solution.moved.empty());
  EXPECT_EQ(solution.variables, 0U);
  EXPECT_EQ(solution.energy, solution.energy_start);
  IntentProblem locked = tests::usual_face().problem({face.drawn(Face::mouth(), line)});
  locked.free.clear();
  EXPECT_TRUE(tests::usual_face().solve(locked).moved.empty());
}

TEST(IntentBadInput, ARigWithoutControlsStaysAsItIs) {
  Face face;
  face.ready();
  EXPECT_TRUE(face.solve(face.problem({face.drawn(Face::mouth(), {{300, 700}, {700, 700}})})).pose.empty());
}

TEST(IntentBadInput, LinesThatTurnBackUponThemselvesGivePlainNumbers) {
  const Face face = tests::usual_face();
  tests::Random random(12);
  for (int run = 0; run < 40; ++run) {
    Line line{{random(0, 1000), random(0, 1000)}};
    const std::size_t count = 2 + random.index(20);
    for (std::size_t i = 0; i < count; ++i) {
      const PxPoint last = line.back();
      line.push_back(random.index(4) == 0 ? last : PxPoint{random(0, 1000), random(0, 1000)});
      if (random.index(3) == 0) line.push_back(last);
    }
    plain(face, face.problem({face.drawn(Face::mouth(), line), face.drawn(Face::left_brow(), tests::backwards(line))}));
  }
}

/// A rig by hand that may give what files cannot: ranges of zero and shapes that are no numbers.
class Broken final : public rig::Rig {
 public:
  Broken(const Face& face, std::vector<rig::Parameter> parameters, std::size_t spoiled)
      : face_(face), parameters_(std::move(parameters)), spoiled_(spoiled) {}
  [[nodiscard]] std::span<const rig::Parameter> parameters() const override { return parameters_; }
  [[nodiscard]] std::size_t vertex_count() const override { return face_.rig->vertex_count(); }
  void evaluate(std::span<const double> pose, std::span<geometry::ModelPoint> positions) const override {
    face_.rig->evaluate(pose, positions);
    if (spoiled_ < pose.size() && pose[spoiled_] != 0.0) {
      for (std::size_t v = 0; v < positions.size(); v += 3) positions[v].y = NAN;
    }
  }
  [[nodiscard]] std::unique_ptr<rig::BoundVertices> bind(std::span<const std::uint32_t> vertices) const override {
    return std::make_unique<Bound>(*this, vertices);
  }

 private:
  class Bound final : public rig::BoundVertices {
   public:
    Bound(const Broken& whole, std::span<const std::uint32_t> vertices)
        : whole_(whole), vertices_(vertices.begin(), vertices.end()), all_(whole.vertex_count()) {}
    [[nodiscard]] std::size_t vertex_count() const override { return vertices_.size(); }
    void evaluate(std::span<const double> pose, std::span<geometry::ModelPoint> positions) override {
      whole_.evaluate(pose, all_);
      for (std::size_t i = 0; i < vertices_.size(); ++i) positions[i] = all_[vertices_[i]];
    }
    [[nodiscard]] bool moves(std::size_t) const override { return true; }
    [[nodiscard]] std::optional<rig::LinearForm> linearize(std::span<const double>,
                                                           std::span<const std::size_t>) override {
      return std::nullopt;
    }

   private:
    const Broken& whole_;
    std::vector<std::uint32_t> vertices_;
    std::vector<geometry::ModelPoint> all_;
  };

  const Face& face_;
  std::vector<rig::Parameter> parameters_;
  std::size_t spoiled_;
};

TEST(IntentBadInput, AControlWithoutRangeStaysAndTheOthersMove) {
  const Face face = tests::usual_face();
  std::vector<rig::Parameter> parameters(face.rig->parameters().begin(), face.rig->parameters().end());
  parameters[face.number("jawOpen")].maximum = 0;
  const Broken rig(face, parameters, 99);
  const WholeModel whole = measure_whole_model(rig);
  for (const double movement : whole.movement) EXPECT_TRUE(std::isfinite(movement));
  EXPECT_EQ(whole.movement[face.number("jawOpen")], 0);
  SolveWorkspace work;
  const Line line = face.seen(Face::mouth(), face.pose({{"cornerLeft", 0.6}}));
  const auto solution = solve(rig, whole, face.problem({face.drawn(Face::mouth(), line)}), {}, work).value();
  EXPECT_EQ(solution.pose[face.number("jawOpen")], 0);
  EXPECT_NEAR(solution.pose[face.number("cornerLeft")], 0.6, 0.1);
}

TEST(IntentBadInput, AShapeThatIsNoNumberLeavesThePoseOfTheOthersPlain) {
  const Face face = tests::usual_face();
  const std::vector<rig::Parameter> parameters(face.rig->parameters().begin(), face.rig->parameters().end());
  const std::size_t spoiled = face.number("lipUp");
  const Broken rig(face, parameters, spoiled);
  const WholeModel whole = measure_whole_model(rig);
  for (const double movement : whole.movement) EXPECT_TRUE(std::isfinite(movement));
  EXPECT_TRUE(std::isfinite(whole.size));
  SolveWorkspace work;
  const Line line = face.seen(Face::mouth(), face.pose({{"cornerLeft", 0.6}}));
  const auto solution = solve(rig, whole, face.problem({face.drawn(Face::mouth(), line)}), {}, work).value();
  EXPECT_EQ(solution.pose[spoiled], 0);
  for (const double value : solution.pose) EXPECT_TRUE(std::isfinite(value));
  EXPECT_TRUE(std::isfinite(solution.energy));
}

}  // namespace
}  // namespace penpose::intent
