#include <algorithm>
#include <gtest/gtest.h>
#include <map>

#include "core/base/json/json.h"
#include "core/io/model/read_model.h"
#include "core/io/model/write_model.h"
#include "core/io/project/read_document.h"
#include "core/io/project/write_document.h"
#include "tests/support/document_hand.h"

// Other targets of controls, and corrections of poses, in files.

namespace penpose::io {
namespace {

using articulation::CurveRole;
using document::BeginDeformer;
using document::SketchCurve;
using tests::DocumentHand;

class OtherTargets : public testing::Test {
 protected:
  OtherTargets() {
    sketch("up", hand.line(-0.3, 0, 0.3, 0), hand.line(-0.3, 0.25, 0.3, 0.25));
    sketch("aside", hand.line(0, -0.2, 0, 0.2), hand.line(0.15, -0.2, 0.15, 0.2));
    hand.does(document::DrawBetween{"up", 0.5, hand.view, hand.line(-0.3, -0.1, 0.3, -0.1)});
    hand.does(document::SetParameters{{{"up", 1}, {"aside", 0.8}}});
    hand.does(document::BeginCorrection{"both", {}});
    hand.does(SketchCurve{CurveRole::general, hand.view, hand.diamond(0.8)});
    hand.does(SketchCurve{CurveRole::specific, hand.view, hand.diamond(0.5)});
    hand.does(SketchCurve{CurveRole::reference, hand.view, hand.line(-0.1, 0.25, 0.4, 0.25)});
    hand.does(SketchCurve{CurveRole::target, hand.view, hand.line(-0.1, 0.05, 0.4, 0.05)});
  }
  void sketch(const std::string& name, const std::vector<geometry::PxPoint>& from,
              const std::vector<geometry::PxPoint>& to) {
    hand.does(BeginDeformer{name, articulation::Mode::translate, {}, 0, 1});
    hand.does(SketchCurve{CurveRole::general, hand.view, hand.diamond(0.8)});
    hand.does(SketchCurve{CurveRole::specific, hand.view, hand.diamond(0.4)});
    hand.does(SketchCurve{CurveRole::reference, hand.view, from});
    hand.does(SketchCurve{CurveRole::target, hand.view, to});
  }
  DocumentHand hand;
};

TEST_F(OtherTargets, AProjectComesBackToTheSameState) {
  const auto bytes = write_project(hand.document()).value();
  const auto again = read_document(bytes, "face.glb");
  ASSERT_TRUE(again.ok()) << again.error().line();
  EXPECT_TRUE(again->model->notes.empty()) << again->model->notes.front();
  ASSERT_NE(again->model->corrections, nullptr);
  EXPECT_EQ(document::DocumentHasher()(*again), hand.state());
  const auto before = document::posed_positions(document::model_of(hand.document()));
  const auto after = document::posed_positions(document::model_of(*again));
  for (std::size_t v = 0; v < before.size(); ++v) EXPECT_EQ(before[v], after[v]) << v;
}

TEST_F(OtherTargets, ASketchInTheMakingComesBackToo) {
  hand.does(document::BeginCorrection{"more", {}});
  hand.does(document::TakeRegion{articulation::Reach::front, {}});
  hand.does(SketchCurve{CurveRole::general, hand.view, hand.diamond(0.8)});
  const auto again = read_document(write_project(hand.document()).value(), "face.glb");
  ASSERT_TRUE(again.ok()) << again.error().line();
  EXPECT_EQ(document::DocumentHasher()(*again), hand.state());
}

/// The weights that a file's first mesh shows its targets with, by name.
std::map<std::string, double> weights_of(base::Bytes bytes) {
  const std::string text(bytes.begin(), bytes.end());
  const auto begin = text.find('{');
  const auto size = static_cast<std::size_t>(bytes[12]) | static_cast<std::size_t>(bytes[13]) << 8U |
                    static_cast<std::size_t>(bytes[14]) << 16U;
  const auto json = json::Json::parse(text.substr(begin, size));
  std::map<std::string, double> weights;
  const auto& mesh = json["meshes"][0];
  for (std::size_t i = 0; i < mesh["weights"].size(); ++i) {
    weights[mesh["extras"]["targetNames"][i].get<std::string>()] = mesh["weights"][i].get<double>();
  }
  return weights;
}

TEST_F(OtherTargets, OtherProgramsSeeTheCorrectionAsATargetWithItsWeight) {
  const auto weight = [&] { return weights_of(write_glb(document::model_of(hand.document())).value()); };
  EXPECT_NEAR(weight().at("both"), 1, 1e-9);
  hand.does(document::SetParameters{{{"up", 0.5}}});
  EXPECT_NEAR(weight().at("both"), 0.5, 1e-9);
  double between = 0;
  for (const auto& [name, value] : weight()) {
    if (name.starts_with("up~")) between = std::max(between, value);
  }
  EXPECT_NEAR(between, 1, 1e-6) << "the other target is a target of its own, all there at its value";
  hand.does(document::SetParameters{{{"aside", 0}}});
  EXPECT_EQ(weight().at("both"), 0);
}

TEST_F(OtherTargets, AnAnimationCarriesTheWeightOfTheCorrection) {
  hand.does(document::SetParameters{{{"up", 0}, {"aside", 0}}});
  hand.does(document::SetKey{0, ""});
  hand.does(document::SetParameters{{{"up", 1}, {"aside", 0.8}}});
  hand.does(document::SetKey{1, ""});
  WriteReport report;
  const auto bytes = write_glb(document::model_of(hand.document()), {}, &report);
  ASSERT_TRUE(bytes.ok()) << bytes.error().line();
  EXPECT_LT(report.bake_error, 1e-3) << "also between the keys, where the product is no straight line";
  const auto model = read_model(*bytes, "clip.glb");
  ASSERT_TRUE(model.ok()) << model.error().line();
  EXPECT_EQ(model->corrections->size(), 1U);
  EXPECT_EQ(model->shapes ? model->shapes->parameters().size() : 0,
            hand.document().model->shapes ? hand.document().model->shapes->parameters().size() : 0)
      << "what only shows the correction is no shape";
}

}  // namespace
}  // namespace penpose::io
