#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/document/time/animation_sampling.h"
#include "core/io/gltf/read/read_gltf.h"
#include "core/io/model/write_model.h"
#include "core/io/project/internal/project_json.h"
#include "core/io/project/read_document.h"
#include "core/io/project/write_document.h"
#include "tests/support/document_hand.h"
#include "tests/support/models/model_samples.h"
#include "tests/support/random_session.h"

namespace penpose::io {
namespace {

using document::Document;
using document::DocumentState;
using tests::DocumentHand;

DocumentState state_of(const Document& document) { return document::DocumentHasher()(document); }

/// Written to a file and read again. Must be the same document.
Document round_trip(const Document& document, const std::string& what = {}) {
  const auto bytes = write_project(document).value();
  auto again = read_document(bytes, "project.glb");
  EXPECT_TRUE(again.ok()) << what << ": " << (again.ok() ? "" : again.error().line());
  if (!again) return document;
  EXPECT_EQ(state_of(*again), state_of(document))
      << what << ": " << testing::PrintToString(differing_parts(state_of(*again), state_of(document)));
  return *again;
}

/// A document with one of everything that a project holds.
DocumentHand full_hand() {
  using namespace document;  // NOLINT(google-build-using-namespace): every line names a command
  DocumentHand hand;
  hand.sketch("up");
  hand.does(SetParameters{{{"lift", 0.1}, {"up", 1.0 / 3}, {"base.ry", 0.7}}});
  hand.does(LockParameters{{"base.rx", "up"}, true});
  hand.does(SetPressureWeighting{true});
  hand.does(SetHand{0.5});
  hand.does(DrawReference{hand.view, hand.line(-0.5, 0.5, 0.5, 0.5)});
  hand.does(NameCurve{CurveId{1}, "brow \xc3\xa9"});
  hand.does(DrawTarget{CurveId{1}, hand.view, hand.line(-0.5, 0.6, 0.5, 0.6), std::vector<double>(21, 0.3)});
  hand.does(DrawFaceLine{{hand.view, hand.line(-0.5, 0.45, 0.5, 0.45)}});
  hand.does(SetNeutral{});
  hand.does(DrawFaceLine{{hand.view, hand.line(-0.5, 0.55, 0.5, 0.55)}});
  hand.does(DrawFaceLine{{hand.view, hand.line(-0.5, -0.55, 0.5, -0.65)}});
  hand.does(NameFaceLine{CurveId{hand.document().last_curve}, {}, true});
  hand.does(DrawReference{hand.view, hand.line(-0.5, -0.5, 0.5, -0.5)});
  hand.does(DrawConstraint{hand.view, hand.line(-0.5, 0, 0.5, 0.1)});
  hand.does(Pin{hand.view, hand.seen(0, -0.8)});
  hand.does(DeleteCurve{CurveId{5}});
  hand.does(SetKey{0.1, ""});
  hand.does(SetParameters{{{"lift", 0.9}, {"up", 0.5}, {"base.ry", -0.3}}});
  hand.does(SetKey{2, "smile \"x\""});
  hand.does(SetKeyKind{{{0.1}, {}}, KeyKind::linear});
  hand.does(SetKeySlopes{2, "lift", -0.1, 0.2});
  hand.does(SetKeyKind{{{2}, {"up"}}, KeyKind::overshoot});
  hand.does(SetKeySlopes{2, "up", 5, 1});
  hand.does(SetSound{"sounds/talk \xc3\xa9.wav", {0x123456789abcdef0U, 0xfU}, -1.0 / 3});
  hand.does(SetWords{{0.1, 1.0 / 3}, {"h\xc3\xa9llo", "there"}});
  hand.does(SetBookmark{1.0 / 3, "hit \"x\"", 4});
  hand.does(SetBookmark{2, "", 0});
  hand.does(SetMouth{"open", {{"up", 0.25}, {"lift", 1.0 / 3}}});
  hand.does(SetMouth{"rest", {}});
  hand.does(KeyMouths{{0.5, 0.75}, {"open", "rest"}});
  hand.does(GoToTime{1.0 / 3});
  hand.does(DrawReference{hand.view, hand.line(-0.3, -0.2, 0.3, -0.2)});
  hand.does(SaveView{"front/top", hand.view});
  View side = hand.view;
  side.camera.eye = {1.0 / 3, 0.2, 5};
  side.viewport = {1600, 900};
  hand.does(SaveView{"side", side, 7});
  hand.does(KeyCamera{0, hand.view, KeyKind::stepped});
  hand.does(KeyCamera{1.0 / 3, side});
  hand.does(SetReference{
      {"films/take \xc3\xa9.mp4", {0x123456789abcdef0U, 0xfU}, -1.0 / 3, 0.25, true, {0, 1, 0}, 2, {0.5, 0.25}, 0.2}});
  hand.does(BeginDeformer{"next", articulation::Mode::rotate, articulation::Sphere{{0, 0, -0.5}, 0.8}, -0.5, 1.5});
  hand.does(SketchCurve{articulation::CurveRole::general, side, hand.diamond(0.8)});
  hand.does(SketchCurve{articulation::CurveRole::specific, side, hand.diamond(0.4)});
  hand.does(SketchCurve{articulation::CurveRole::reference, hand.view, hand.line(-0.4, 0, 0.4, 0)});
  return hand;
}

TEST(Project, EverythingComesBackAsItWas) {
  const Document document = full_hand().document();
  const Document again = round_trip(document);
  EXPECT_EQ(again.pose, document.pose);
  EXPECT_EQ(again.locked, document.locked);
  ASSERT_EQ(again.curves.size(), document.curves.size());
  for (std::size_t i = 0; i < again.curves.size(); ++i) EXPECT_EQ(*again.curves[i], *document.curves[i]) << i;
  EXPECT_EQ(*again.timeline, *document.timeline);
  EXPECT_EQ(again.time_s, document.time_s);
  ASSERT_EQ(again.views.size(), 2U);
  EXPECT_EQ(*again.views[1], *document.views[1]);
  EXPECT_EQ(*again.camera, *document.camera);
  EXPECT_EQ(*again.reference, *document.reference);
  EXPECT_EQ(*again.pending, *document.pending);
  const auto saved = write_project(again).value();
  EXPECT_EQ(saved.size(), write_project(document).value().size());
  EXPECT_EQ(write_project(round_trip(again)).value(), saved) << "what is saved again and again stays as it is";
}

TEST(Project, WorkGoesOnAsIfItHadNeverBeenClosed) {
  auto open = full_hand();
  DocumentHand again(round_trip(open.document()));
  for (DocumentHand* hand : {&open, &again}) {
    hand->does(document::SketchCurve{articulation::CurveRole::target, hand->view, hand->line(-0.4, 0.3, 0.4, 0.3)});
    hand->does(document::DrawReference{hand->view, hand->line(-0.3, 0.3, 0.3, 0.3)});
    hand->does(document::DragTarget{document::CurveId{1}, {0, -10}});
    hand->does(document::GoToTime{1});
  }
  EXPECT_EQ(again.state(), open.state());
}

TEST(Project, EveryStepOfASketchCanBeSaved) {
  using articulation::CurveRole;
  DocumentHand hand;
  hand.does(
      document::BeginDeformer{"up", articulation::Mode::automatic, articulation::PartSurface{"eye \xc3\xa9"}, 0, 1});
  round_trip(hand.document(), "begun");
  hand.does(document::BeginDeformer{"", articulation::Mode::automatic, {}, 0, 1});
  hand.does(document::SketchCurve{CurveRole::general, hand.view, hand.diamond(0.8)});
  round_trip(hand.document(), "general");
  hand.does(document::SketchCurve{CurveRole::specific, hand.view, hand.diamond(0.4)});
  round_trip(hand.document(), "specific");
  hand.view.camera.eye.x = 1;
  hand.view.viewport = {640, 480};
  hand.does(document::SketchCurve{CurveRole::reference, hand.view, hand.line(-0.4, 0, 0.4, 0)});
  round_trip(hand.document(), "reference");
  hand.does(document::SketchCurve{CurveRole::reference, hand.view, {}});
  round_trip(hand.document(), "no reference");
  hand.does(document::SketchCurve{CurveRole::target, hand.view, hand.line(-0.4, 0.3, 0.4, 0.3)});
  round_trip(hand.document(), "done");
}

TEST(Project, DocumentsThatARandomHandMadeComeBack) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    tests::SessionScript script(document::make_document(tests::sheet_model()));
    tests::RandomHand(script, seed).run(25);
    round_trip(script.document(), "seed " + std::to_string(seed));
  }
}

TEST(Project, KeysMayLieCloserThanFilesOfOtherProgramsCanSay) {
  DocumentHand hand;
  double time_s = 1000;
  for (int i = 0; i < 5; ++i) {
    hand.does(document::SetParameters{{{"lift", 0.2 * i}, {"base.rx", 0.1 * i}}});
    hand.does(document::SetKey{time_s, ""});
    time_s = std::nextafter(time_s, 2000.0);
  }
  EXPECT_EQ(round_trip(hand.document()).timeline->keys.size(), 5U);
  DocumentHand start;
  start.does(document::SetKey{0, ""});
  start.does(document::SetKey{1e-300, ""});
  start.does(document::SetKey{36000, ""});
  round_trip(start.document());
}

TEST(Project, AnAnimationOfTheModelIsNotTakenForTheTimeline) {
  // Neither shapes nor turned joints: the timeline of this model moves nothing that an animation could say.
  document::Model model =
      document::make_model(tests::sheet_model().mesh, nullptr, tests::sheet_model().skeleton).value();
  document::Channel channel{document::ChannelTarget::translation, 0, document::Interpolation::linear, {0, 1}, {}};
  channel.values = {0, 0, 0, 1, 0, 0};
  model.animations = {{"timeline", {channel}}};
  DocumentHand still(document::make_document(model));
  still.does(document::SetKey{1, ""});
  EXPECT_EQ(round_trip(still.document(), "still").model->animations.size(), 1U);
  still.does(document::SetParameters{{{"base.rx", 0.5}}});
  still.does(document::SetKey{2, ""});
  EXPECT_EQ(round_trip(still.document(), "turned").model->animations.size(), 1U);
  DocumentHand none(document::make_document(model));
  EXPECT_EQ(round_trip(none.document(), "no keys").model->animations.size(), 1U);
}

TEST(Project, OtherProgramsSeeAModelWithItsTimeline) {
  const auto hand = full_hand();
  const auto bytes = write_document(hand.document(), "a.glb").value();
  EXPECT_EQ(bytes, write_project(hand.document()).value());
  const auto model = read_gltf(bytes).value();
  EXPECT_EQ(model.pose, hand.document().pose);
  ASSERT_EQ(model.animations.size(), 1U);
  EXPECT_EQ(model.animations[0].name, "timeline");
  EXPECT_TRUE(write_document(hand.document(), "a.obj").ok());
  EXPECT_FALSE(write_document(hand.document(), "a.png").ok());
}

TEST(Project, APlainModelIsADocumentThatNothingWasDoneTo) {
  const auto model = tests::full_model();
  const auto from_glb = read_document(write_glb(model).value(), "a.glb").value();
  EXPECT_EQ(state_of(from_glb), state_of(document::make_document(model)));
  EXPECT_TRUE(from_glb.curves.empty() && from_glb.views.empty() && from_glb.timeline->keys.empty());
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  const auto from_obj = read_document({reinterpret_cast<const std::uint8_t*>(obj.data()), obj.size()}, "a.obj").value();
  EXPECT_EQ(from_obj.model->mesh->vertex_count(), 3U);
  EXPECT_FALSE(read_document({}, "a.glb").ok());
}

// What can be wrong with the member "project".

const std::string k_at = "/extras/penpose/project";

/// What is changed is changed as nlohmann's value, which can name any place.
json::Json ours(const nlohmann::json& value) { return json::parse_json(base::as_bytes(value.dump())).value(); }

base::Result<Document> read(const nlohmann::json& project) {
  const Document document = full_hand().document();
  return read_project(ours(project), k_at, *document.model);
}

nlohmann::json full_project() { return nlohmann::json::parse(project_to_json(full_hand().document()).dump()); }

/// Pointers to every member and item, the first two of every list.
void gather(const nlohmann::json& value, const nlohmann::json::json_pointer& at,
            std::vector<nlohmann::json::json_pointer>& out) {
  if (value.is_object()) {
    for (const auto& [name, member] : value.items()) {
      out.push_back(at / name);
      gather(member, at / name, out);
    }
  } else if (value.is_array()) {
    for (std::size_t i = 0; i < std::min<std::size_t>(value.size(), 2); ++i) {
      out.push_back(at / i);
      gather(value[i], at / i, out);
    }
  }
}

TEST(ProjectJson, IsReadBackAsItIsWritten) {
  const auto document = read(full_project());
  ASSERT_TRUE(document.ok()) << document.error().line();
  // As values: the other library does not always write the shortest decimals.
  EXPECT_TRUE(nlohmann::json::parse(project_to_json(*document).dump()) == full_project());
}

TEST(ProjectJson, WhateverIsMissingOrOfAnotherTypeIsToldWithItsPlace) {
  const nlohmann::json project = full_project();
  std::vector<nlohmann::json::json_pointer> places;
  gather(project, nlohmann::json::json_pointer(), places);
  EXPECT_GT(places.size(), 70U);
  const document::Model model = *full_hand().document().model;
  const auto check = [&](const nlohmann::json& changed, const std::string& what, bool must_fail) {
    const auto document = read_project(ours(changed), k_at, model);
    if (document) {
      EXPECT_FALSE(must_fail) << what;
      // What is accepted can be worked with and saved.
      static_cast<void>(round_trip(*document, what));
      return;
    }
    EXPECT_TRUE(document.error().place.starts_with(k_at)) << what << ": " << document.error().line();
    EXPECT_FALSE(document.error().what.empty() || document.error().remedy.empty()) << what;
  };
  const std::vector<nlohmann::json> others{nullptr, true,   -1,        0, 1e300, 0.5, "x", nlohmann::json::array(),
                                           {{}},    {1, 2}, {{"a", 1}}};
  for (const auto& place : places) {
    nlohmann::json changed = project;
    if (place.back().find_first_not_of("0123456789") == std::string::npos) {
      changed[place.parent_pointer()].erase(std::stoul(place.back()));
    } else {
      changed[place.parent_pointer()].erase(place.back());
    }
    check(changed, "without " + place.to_string(), false);
    for (const nlohmann::json& other : others) {
      changed = project;
      const bool same_type = other.type_name() == std::string(changed[place].type_name());
      changed[place] = other;
      check(changed, place.to_string() + " = " + other.dump(), !same_type);
    }
  }
  for (const nlohmann::json& other : others) {
    if (!other.is_object()) check(other, other.dump(), true);
  }
}

TEST(ProjectJson, ErrorsSayWhereTheyAre) {
  const auto place_of = [](const std::function<void(nlohmann::json&)>& change) {
    nlohmann::json project = full_project();
    change(project);
    const auto document = read(project);
    EXPECT_FALSE(document.ok());
    return document.ok() ? std::string() : document.error().place.substr(k_at.size());
  };
  EXPECT_EQ(place_of([](nlohmann::json& p) { p["curves"][0]["id"] = 0; }), "/curves/0/id");
  EXPECT_EQ(place_of([](nlohmann::json& p) { p["curves"][1]["id"] = 1; }), "/curves/1/id") << "used twice";
  EXPECT_EQ(place_of([](nlohmann::json& p) { p["last_curve"] = 2; }), "/curves/1/id");
  EXPECT_EQ(place_of([](nlohmann::json& p) { p["curves"][0]["role"] = "pin"; }), "/curves/0/role");
  EXPECT_EQ(place_of([](nlohmann::json& p) { p["curves"][0]["points"][3][0] = 392; }), "/curves/0/points/3");
  EXPECT_EQ(place_of([](nlohmann::json& p) { p["curves"][0]["points"][3] = {0, 2, -1, 0}; }), "/curves/0/points/3");
  EXPECT_EQ(place_of([](nlohmann::json& p) { p["curves"][0]["target"]["view"] = "front"; }), "/curves/0/target/view");
  EXPECT_EQ(place_of([](nlohmann::json& p) { p["curves"][0]["target"]["line"][1][2] = 1.5; }),
            "/curves/0/target/line/1");
  EXPECT_EQ(place_of([](nlohmann::json& p) { p["curves"][0]["target"]["points"][1][3] = -1; }),
            "/curves/0/target/points/1");
  EXPECT_EQ(place_of([](nlohmann::json& p) { p["curves"][0]["target"]["points"].erase(0); }), "/curves/0/target");
  EXPECT_EQ(place_of([](nlohmann::json& p) { p["curves"][1]["target"] = p["curves"][0]["target"]; }),
            "/curves/1/target");
  EXPECT_EQ(place_of([](nlohmann::json& p) { p["timeline"]["keys"][1]["time_s"] = 0.1; }), "/timeline/keys/1/time_s");
  EXPECT_EQ(place_of([](nlohmann::json& p) { p["timeline"]["keys"][1]["pose"].erase(0); }), "/timeline/keys/1/pose");
  EXPECT_EQ(place_of([](nlohmann::json& p) { p["timeline"]["keys"][1]["name"] = 3; }), "/timeline/keys/1/name");
  EXPECT_EQ(place_of([](nlohmann::json& p) { p["locked"][0] = 3; }), "/locked/0");
  EXPECT_EQ(place_of([](nlohmann::json& p) { p["views"][1]["name"] = "front/top"; }), "/views/1/name");
  EXPECT_EQ(place_of([](nlohmann::json& p) { p["time_s"] = 36001; }), "/time_s");
  EXPECT_EQ(place_of([](nlohmann::json& p) { p["words"][1]["from_s"] = 0.05; }), "/words/1/from_s");
  EXPECT_EQ(place_of([](nlohmann::json& p) { p["words"][0]["word"] = ""; }), "/words/0/word");
  EXPECT_EQ(place_of([](nlohmann::json& p) { p["bookmarks"][1]["time_s"] = 0.1; }), "/bookmarks/1/time_s");
  EXPECT_EQ(place_of([](nlohmann::json& p) { p["bookmarks"][0]["color"] = 6; }), "/bookmarks/0/color");
  EXPECT_EQ(place_of([](nlohmann::json& p) { p["bookmarks"][0]["name"] = std::string(201, 'a'); }),
            "/bookmarks/0/name");
  EXPECT_EQ(place_of([](nlohmann::json& p) { p["pending"][1] = "clear_curves"; }), "/pending/1") << "only a sketch";
  EXPECT_EQ(place_of([](nlohmann::json& p) { p["pending"][0] = "begin_deformer name=lift"; }), "/pending/0");
}

TEST(ProjectJson, ALockOfAParameterThatIsGoneIsForgotten) {
  nlohmann::json project = full_project();
  project["locked"] = {"up", "gone", "base.rx", "up"};
  EXPECT_EQ(read(project).value().locked, (std::vector<std::string>{"base.rx", "up"}));
}

TEST(Project, ClipsComeBackWithWhatTheyAreOf) {
  using namespace document;  // NOLINT(google-build-using-namespace): every line names a command
  Model model = tests::sheet_model();
  const Channel lifted{ChannelTarget::weights, 0, Interpolation::linear, {0, 1, 2}, {0, 0, 0.5, 0, 0.25, 0}};
  const Channel leant{ChannelTarget::weights, 0, Interpolation::linear, {0, 0.5}, {0, 0, 0, 0.5}};
  model.animations = {{"walk", {lifted}}, {"nod", {leant}}, {"rest", {lifted}}};
  DocumentHand hand(read_document(io::write_model(model, "a.glb").value(), "a.glb").value());
  hand.does(SetKey{0.5, "own"});
  hand.does(OpenClip{1});
  hand.does(SetMouth{"open", {{"lift", 0.75}}});
  hand.does(KeyMouths{{0.25}, {"open"}});
  hand.does(OpenClip{0});
  hand.does(SetKeyValues{{{1}, {"lift"}}, {0.125}});
  hand.does(AddClip{"more", true});
  hand.does(ShowClip{2});
  const Document again = round_trip(hand.document());
  ASSERT_EQ(again.clips.size(), 4U);
  EXPECT_EQ(again.clip, 2U);
  EXPECT_EQ(again.clips[1]->animation, 1U);
  EXPECT_EQ(again.clips[2]->animation, 0U);
  EXPECT_EQ(again.model->animations.size(), 3U);
  EXPECT_EQ(sample(*again.model, again.model->animations[0], 1).weights[0], 0.125);
  round_trip(again, "once more");
}

TEST(Project, AClipWithoutKeysIsNoAnimationAnyMore) {
  using namespace document;  // NOLINT(google-build-using-namespace): every line names a command
  Model model = tests::sheet_model();
  const Channel lifted{ChannelTarget::weights, 0, Interpolation::linear, {0, 1}, {0, 0, 0.5, 0}};
  model.animations = {{"walk", {lifted}}, {"nod", {lifted}}};
  DocumentHand hand(read_document(io::write_model(model, "a.glb").value(), "a.glb").value());
  hand.does(OpenClip{1});
  hand.does(OpenClip{0});
  hand.does(DeleteKeys{{{0, 1}, {}}});
  const Document again = round_trip(hand.document());
  ASSERT_EQ(again.model->animations.size(), 1U);
  EXPECT_EQ(again.clips[0]->animation, 0U);
  EXPECT_FALSE(again.clips[1]->animation.has_value());
}

}  // namespace
}  // namespace penpose::io
