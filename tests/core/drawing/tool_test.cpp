#include "core/drawing/tool.h"

#include <gtest/gtest.h>

#include "tests/support/document_hand.h"

namespace penpose::drawing {
namespace {

using document::Command;
using document::CurveId;
using tests::DocumentHand;

/// A line across the sheet, pressed harder and harder.
curve::Stroke stroke_at(const DocumentHand& hand, double y) {
  curve::Stroke stroke;
  for (const auto& p : hand.line(-0.5, y, 0.5, y)) {
    stroke.push_back({p, static_cast<double>(stroke.size()) / 32, static_cast<std::int64_t>(stroke.size())});
  }
  return stroke;
}

class ToolCommands : public testing::Test {
 protected:
  base::Result<Command> meant(const Tool& tool, bool eraser = false) {
    return command_of(hand.document(), tool, hand.view, stroke, eraser);
  }
  /// The command must be of that kind; gives it.
  template <typename One>
  One means(const Tool& tool, bool eraser = false) {
    const auto command = meant(tool, eraser);
    EXPECT_TRUE(command.ok() && command->template holds<One>()) << One::k_called.name;
    return command.ok() && command->template holds<One>() ? *command->template get_if<One>() : One{};
  }
  static Tool tool(ToolKind kind) {
    Tool made;
    made.kind = kind;
    return made;
  }
  void reference(double y) { hand.does(document::DrawReference{hand.view, hand.line(-0.5, y, 0.5, y)}); }
  void target(std::uint32_t curve, double y) {
    hand.does(document::DrawTarget{CurveId{curve}, hand.view, hand.line(-0.5, y, 0.5, y), {}});
  }

  DocumentHand hand;
  curve::Stroke stroke = stroke_at(hand, 0.5);
  std::vector<geometry::PxPoint> line = curve::positions_of(stroke);
};

TEST(Tool, ATapIsNoLineUnlessThePenGoesSomewhere) {
  const geometry::Viewport picture{1000, 1000};
  EXPECT_TRUE(is_tap({}, picture));
  EXPECT_TRUE(is_tap({{{100, 100}, 1, 0}, {{103, 102}, 1, 1}, {{100, 104}, 1, 2}}, picture));
  EXPECT_FALSE(is_tap({{{100, 100}, 1, 0}, {{106, 100}, 1, 1}}, picture));
  EXPECT_FALSE(is_tap({{{100, 100}, 1, 0}, {{130, 100}, 1, 1}, {{100, 100}, 1, 2}}, picture)) << "there and back";
  EXPECT_TRUE(is_tap({{{100, 100}, 1, 0}, {{106, 100}, 1, 1}}, {2000, 2000})) << "of a denser screen";
}

TEST(Tool, ReadsBackAsItWasWritten) {
  for (const auto kind :
       {ToolKind::pose, ToolKind::reference, ToolKind::target, ToolKind::oversketch, ToolKind::constraint,
        ToolKind::pin, ToolKind::articulate, ToolKind::redraw, ToolKind::erase, ToolKind::none}) {
    const Tool tool{kind, CurveId{7}, true, "deformer 1;=", articulation::CurveRole::general};
    EXPECT_EQ(parse_tool(to_text(tool)).value(), tool) << to_text(tool);
    Tool plain;
    plain.kind = kind;
    EXPECT_EQ(parse_tool(to_text(plain)).value(), plain) << to_text(plain);
  }
  EXPECT_EQ(to_text(Tool{}), "");
  EXPECT_EQ(to_text(Tool{ToolKind::articulate, {}, true, "", articulation::CurveRole::target}),
            "kind=articulate draw_reference=1");
}

TEST(Tool, ErrorsNameTheMember) {
  EXPECT_EQ(parse_tool("kind=brush").error().place, "kind");
  EXPECT_EQ(parse_tool("kind=").error().place, "kind");
  EXPECT_EQ(parse_tool("size=3").error().place, "size");
  EXPECT_EQ(parse_tool("curve=1 curve=2").error().place, "curve");
}

TEST_F(ToolCommands, PosingAlternatesBetweenReferencesAndTargets) {
  const auto drawn = means<document::DrawReference>(tool(ToolKind::pose));
  EXPECT_EQ(drawn.line, line);
  EXPECT_EQ(drawn.view, hand.view);
  reference(0.5);
  const auto target_of_it = means<document::DrawTarget>(tool(ToolKind::pose));
  EXPECT_EQ(target_of_it.curve, CurveId{1});
  EXPECT_EQ(target_of_it.line, line);
  ASSERT_EQ(target_of_it.pressure.size(), line.size());
  EXPECT_EQ(target_of_it.pressure[16], 0.5);
  target(1, 0.6);
  means<document::DrawReference>(tool(ToolKind::pose));
  hand.does(document::DrawConstraint{hand.view, line});
  means<document::DrawReference>(tool(ToolKind::pose));
}

TEST_F(ToolCommands, ReferencesOnlyAndThenTheirTargetsInOrder) {
  EXPECT_FALSE(meant(tool(ToolKind::target)).ok()) << "nothing waits for a target";
  reference(0.5);
  means<document::DrawReference>(tool(ToolKind::reference));
  reference(-0.5);
  EXPECT_EQ(means<document::DrawTarget>(tool(ToolKind::target)).curve, CurveId{1});
  target(1, 0.6);
  EXPECT_EQ(means<document::DrawTarget>(tool(ToolKind::target)).curve, CurveId{2});
  Tool first = tool(ToolKind::target);
  first.curve = CurveId{1};
  EXPECT_EQ(means<document::DrawTarget>(first).curve, CurveId{1});
}

TEST_F(ToolCommands, OversketchingTakesTheLastTarget) {
  EXPECT_FALSE(meant(tool(ToolKind::oversketch)).ok());
  reference(0.5);
  EXPECT_FALSE(meant(tool(ToolKind::oversketch)).ok());
  target(1, 0.6);
  reference(-0.5);
  EXPECT_EQ(means<document::OversketchTarget>(tool(ToolKind::oversketch)).curve, CurveId{1});
  target(2, -0.4);
  EXPECT_EQ(means<document::OversketchTarget>(tool(ToolKind::oversketch)).curve, CurveId{2});
  Tool first = tool(ToolKind::oversketch);
  first.curve = CurveId{1};
  EXPECT_EQ(means<document::OversketchTarget>(first).curve, CurveId{1});
}

TEST_F(ToolCommands, ConstraintsPinsAndTheEraser) {
  EXPECT_EQ(means<document::DrawConstraint>(tool(ToolKind::constraint)).line, line);
  EXPECT_EQ(means<document::Pin>(tool(ToolKind::pin)).at, line.front()) << "where the pen first touches";
  EXPECT_EQ(means<document::EraseCurves>(tool(ToolKind::erase)).line, line);
  for (const auto kind : {ToolKind::pose, ToolKind::articulate, ToolKind::pin, ToolKind::redraw}) {
    means<document::EraseCurves>(tool(kind), true);
  }
  EXPECT_FALSE(meant(tool(ToolKind::none)).ok());
}

TEST_F(ToolCommands, ArticulatingGoesThroughTheStepsOfADeformer) {
  using articulation::CurveRole;
  Tool inferred = tool(ToolKind::articulate);
  Tool drawn = inferred;
  drawn.draw_reference = true;
  const auto role = [&](const Tool& with) {
    EXPECT_EQ(next_step(hand.document(), with), means<document::SketchCurve>(with).role);
    return means<document::SketchCurve>(with).role;
  };
  EXPECT_EQ(role(inferred), CurveRole::general);
  hand.does(document::BeginDeformer{"up", articulation::Mode::automatic, {}, 0, 1});
  EXPECT_EQ(role(inferred), CurveRole::general);
  hand.does(document::SketchCurve{CurveRole::general, hand.view, hand.diamond(0.8)});
  EXPECT_EQ(role(drawn), CurveRole::specific);
  hand.does(document::SketchCurve{CurveRole::specific, hand.view, hand.diamond(0.4)});
  EXPECT_EQ(role(inferred), CurveRole::target);
  EXPECT_EQ(role(drawn), CurveRole::reference);
  hand.does(document::SketchCurve{CurveRole::reference, hand.view, hand.line(-0.4, 0, 0.4, 0)});
  EXPECT_EQ(role(drawn), CurveRole::target);
  hand.does(document::SketchCurve{CurveRole::target, hand.view, hand.line(-0.4, 0.3, 0.4, 0.3)});
  EXPECT_EQ(role(drawn), CurveRole::general) << "the next deformer";
}

TEST_F(ToolCommands, RedrawingNamesTheDeformerAndTheCurve) {
  Tool redraw = tool(ToolKind::redraw);
  redraw.deformer = "up";
  redraw.role = articulation::CurveRole::reference;
  const auto command = means<document::RedrawCurve>(redraw);
  EXPECT_EQ(command.deformer, "up");
  EXPECT_EQ(command.role, articulation::CurveRole::reference);
  EXPECT_EQ(command.line, line);
}

}  // namespace
}  // namespace penpose::drawing
