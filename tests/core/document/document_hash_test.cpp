#include "core/document/document_hash.h"

#include <functional>
#include <gtest/gtest.h>
#include <set>

#include "tests/support/document_hand.h"
#include "tests/support/random_session.h"

namespace penpose::document {
namespace {

using tests::DocumentHand;

/// A document with one of everything.
Document full_document() {
  DocumentHand hand;
  hand.sketch("up");
  hand.does(SetParameters{{{"lift", 0.5}}});
  hand.does(LockParameters{{"base.rx", "lean"}, true});
  hand.does(DrawReference{hand.view, hand.line(-0.5, 0.5, 0.5, 0.5)});
  hand.does(NameCurve{CurveId{1}, "brow"});
  hand.does(DrawTarget{CurveId{1}, hand.view, hand.line(-0.5, 0.6, 0.5, 0.6), {}});
  hand.does(Pin{hand.view, hand.seen(0, -0.5)});
  hand.does(SetKey{1, "smile"});
  hand.does(SaveView{"front", hand.view});
  hand.does(BeginDeformer{"next", articulation::Mode::automatic, {}, 0, 1});
  Document document = hand.document();
  Model model = *document.model;
  model.animations = {{"walk", {Channel{ChannelTarget::weights, 0, Interpolation::linear, {0}, {0, 0, 0}}}}};
  document.model = std::make_shared<const Model>(std::move(model));
  return document;
}

void on_curve(Document& document, std::size_t i, const std::function<void(PoseCurve&)>& change) {
  PoseCurve curve = *document.curves[i];
  change(curve);
  document.curves[i] = std::make_shared<const PoseCurve>(std::move(curve));
}
void on_target(Document& document, const std::function<void(DrawnTarget&)>& change) {
  on_curve(document, 0, [&](PoseCurve& c) { change(*c.target); });
}
void on_timeline(Document& document, const std::function<void(Timeline&)>& change) {
  Timeline timeline = *document.timeline;
  change(timeline);
  document.timeline = std::make_shared<const Timeline>(std::move(timeline));
}
void on_pending(Document& document, const std::function<void(articulation::Sketch&)>& change) {
  PendingSketch pending = *document.pending;
  change(pending.sketch);
  document.pending = std::make_shared<const PendingSketch>(std::move(pending));
}
void on_view(Document& document, const std::function<void(NamedView&)>& change) {
  NamedView view = *document.views[0];
  change(view);
  document.views[0] = std::make_shared<const NamedView>(std::move(view));
}
void on_model(Document& document, const std::function<void(Model&)>& change) {
  Model model = *document.model;
  change(model);
  document.model = std::make_shared<const Model>(std::move(model));
}

struct Change {
  const char* what;
  const char* part;  ///< the one part that must differ
  std::function<void(Document&)> make;
};

std::vector<Change> changes() {
  using D = Document;
  return {
      {"pose", "parameters", [](D& d) { d.pose[0] = 0.25; }},
      {"pose of a joint", "parameters", [](D& d) { d.pose.back() = 0.25; }},
      {"lock", "parameters", [](D& d) { d.locked.pop_back(); }},
      {"locked name", "parameters", [](D& d) { d.locked[0] = "base.ry"; }},
      {"names run together", "parameters", [](D& d) { d.locked = {"base.rxlean"}; }},
      {"pressure weighting", "parameters", [](D& d) { d.pressure_weighting = true; }},
      {"hand", "parameters", [](D& d) { d.hand = 2; }},
      {"time", "parameters", [](D& d) { d.time_s = 2; }},
      {"last curve", "curves", [](D& d) { d.last_curve = 9; }},
      {"order of curves", "curves", [](D& d) { std::swap(d.curves[0], d.curves[1]); }},
      {"a curve less", "curves", [](D& d) { d.curves.pop_back(); }},
      {"id", "curves", [](D& d) { on_curve(d, 0, [](PoseCurve& c) { c.id.value = 5; }); }},
      {"role", "curves", [](D& d) { on_curve(d, 1, [](PoseCurve& c) { c.role = PoseCurveRole::reference; }); }},
      {"triangle", "curves", [](D& d) { on_curve(d, 0, [](PoseCurve& c) { c.points[3].triangle ^= 1U; }); }},
      {"barycentric", "curves",
       [](D& d) { on_curve(d, 0, [](PoseCurve& c) { c.points[3].barycentric[1] += 1e-15; }); }},
      {"kept", "curves", [](D& d) { on_curve(d, 1, [](PoseCurve& c) { c.kept[0].z += 1; }); }},
      {"target gone", "curves", [](D& d) { on_curve(d, 0, [](PoseCurve& c) { c.target.reset(); }); }},
      {"target's eye", "curves", [](D& d) { on_target(d, [](DrawnTarget& t) { t.view.camera.eye.x = 1; }); }},
      {"target's look", "curves", [](D& d) { on_target(d, [](DrawnTarget& t) { t.view.camera.look_at.x = 1; }); }},
      {"target's up", "curves", [](D& d) { on_target(d, [](DrawnTarget& t) { t.view.camera.up.x = 1; }); }},
      {"target's lens", "curves",
       [](D& d) { on_target(d, [](DrawnTarget& t) { t.view.camera.vertical_fov_degrees = 31; }); }},
      {"target's width", "curves", [](D& d) { on_target(d, [](DrawnTarget& t) { t.view.viewport.width = 1; }); }},
      {"target's height", "curves", [](D& d) { on_target(d, [](DrawnTarget& t) { t.view.viewport.height = 1; }); }},
      {"line", "curves", [](D& d) { on_target(d, [](DrawnTarget& t) { t.line[5].y += 1; }); }},
      {"pressure", "curves", [](D& d) { on_target(d, [](DrawnTarget& t) { t.pressure[5] = 0.5; }); }},
      {"points", "curves", [](D& d) { on_target(d, [](DrawnTarget& t) { t.points[5].x += 1; }); }},
      {"weights", "curves", [](D& d) { on_target(d, [](DrawnTarget& t) { t.weights[5] = 0.5; }); }},
      {"no pending", "deformers", [](D& d) { d.pending.reset(); }},
      {"pending name", "deformers", [](D& d) { on_pending(d, [](auto& s) { s.name = "x"; }); }},
      {"pending mode", "deformers", [](D& d) { on_pending(d, [](auto& s) { s.mode = articulation::Mode::rotate; }); }},
      {"pending surface", "deformers",
       [](D& d) { on_pending(d, [](auto& s) { s.surface = articulation::Sphere{}; }); }},
      {"pending minimum", "deformers", [](D& d) { on_pending(d, [](auto& s) { s.minimum = -1; }); }},
      {"pending maximum", "deformers", [](D& d) { on_pending(d, [](auto& s) { s.maximum = 2; }); }},
      {"pending general", "deformers", [](D& d) { on_pending(d, [](auto& s) {
                                                    s.general = {{1, 2}};
                                                  }); }},
      {"pending specific", "deformers", [](D& d) { on_pending(d, [](auto& s) {
                                                     s.specific = {{1, 2}};
                                                   }); }},
      {"pending reference", "deformers", [](D& d) { on_pending(d, [](auto& s) {
                                                      s.reference = {{1, 2}};
                                                    }); }},
      {"pending camera", "deformers", [](D& d) { on_pending(d, [](auto& s) { s.camera.eye.x = 2; }); }},
      {"pending picture", "deformers", [](D& d) { on_pending(d, [](auto& s) { s.viewport.width = 2; }); }},
      {"key's kind", "keys",
       [](D& d) {
         on_timeline(d, [](Timeline& t) {
           std::vector<ControlKey> list = t.keys[0].controls.list(t.keys[0].pose.size());
           list[1].kind = KeyKind::linear;
           t.keys[0].controls = list;
         });
       }},
      {"key's time", "keys", [](D& d) { on_timeline(d, [](Timeline& t) { t.keys[0].time_s = 2; }); }},
      {"key's pose", "keys",
       [](D& d) {
         on_timeline(d, [](Timeline& t) {
           rig::Pose pose = t.keys[0].pose;
           pose[1] = 0.5;
           t.keys[0].pose = pose;
         });
       }},
      {"key's name", "keys", [](D& d) { on_timeline(d, [](Timeline& t) { t.keys[0].name = ""; }); }},
      {"no key", "keys", [](D& d) { on_timeline(d, [](Timeline& t) { t.keys.clear(); }); }},
      {"animation", "keys", [](D& d) { on_model(d, [](Model& m) { m.animations[0].channels[0].values[0] = 1; }); }},
      {"sound", "keys",
       [](D& d) {
         d.sound = std::make_shared<const SoundReference>(SoundReference{"a.wav", {}, 0});
       }},
      {"mouth", "keys",
       [](D& d) {
         d.mouths.push_back(std::make_shared<const Mouth>(Mouth{"open", {}}));
       }},
      {"spoken", "keys", [](D& d) { d.spoken = std::make_shared<const SpokenMouths>(1); }},
      {"words", "keys", [](D& d) { d.words = std::make_shared<const SpokenWords>(1); }},
      {"bookmarks", "keys", [](D& d) { d.bookmarks = std::make_shared<const Bookmarks>(1); }},
      {"view's name", "curves", [](D& d) { on_view(d, [](NamedView& v) { v.name = "side"; }); }},
      {"view", "curves", [](D& d) { on_view(d, [](NamedView& v) { v.view.camera.eye.y = 1; }); }},
      {"key of a view", "curves", [](D& d) { on_view(d, [](NamedView& v) { v.key = 3; }); }},
      {"reference", "curves",
       [](D& d) {
         d.reference = std::make_shared<const ReferencePicture>(ReferencePicture{"a.png", {}});
       }},
      {"place of the reference", "curves",
       [](D& d) {
         ReferencePicture picture{"a.png", {}};
         picture.card.x = 0.5;
         d.reference = std::make_shared<const ReferencePicture>(picture);
       }},
      {"camera", "keys",
       [](D& d) {
         d.camera = std::make_shared<const CameraTrack>(CameraTrack{{{1, d.views[0]->view, KeyKind::smooth}}});
       }},
      {"cut of the camera", "keys",
       [](D& d) {
         d.camera = std::make_shared<const CameraTrack>(CameraTrack{{{1, d.views[0]->view, KeyKind::stepped}}});
       }},
      {"no view", "curves", [](D& d) { d.views.clear(); }},
      {"curve of the model", "curves", [](D& d) { on_model(d, [](Model& m) { m.curves[0].name = "lip"; }); }},
  };
}

TEST(DocumentHash, EveryMemberChangesItsPartAndNoOther) {
  const Document document = full_document();
  const DocumentState state = DocumentHasher()(document);
  std::set<std::string> seen{state.whole.hex()};
  for (const Change& change : changes()) {
    Document other = document;
    change.make(other);
    const DocumentState changed = DocumentHasher()(other);
    EXPECT_TRUE(seen.insert(changed.whole.hex()).second) << change.what;
    EXPECT_EQ(differing_parts(state, changed), std::vector<std::string_view>{change.part}) << change.what;
  }
}

TEST(DocumentHash, AnotherMeshIsAnotherModel) {
  const Document document = make_document(tests::sheet_model());
  Model model = tests::sheet_model();
  mesh::MeshSource source;
  source.positions.assign(model.mesh->positions().begin(), model.mesh->positions().end());
  source.triangles.assign(model.mesh->triangles().begin(), model.mesh->triangles().end());
  source.positions[3].z += 0.5F;
  model = make_model(mesh::TriangleMesh::build(std::move(source)).value(), model.shapes, model.skeleton).value();
  const auto parts = differing_parts(DocumentHasher()(document), DocumentHasher()(make_document(model)));
  EXPECT_EQ(parts, std::vector<std::string_view>{"model"});
}

TEST(DocumentHash, ADeformerIsADeformerAndAParameter) {
  DocumentHand hand;
  const auto before = hand.state();
  hand.sketch("up");
  EXPECT_EQ(differing_parts(before, hand.state()), (std::vector<std::string_view>{"deformers", "parameters"}));
}

TEST(DocumentHash, TheModelsOwnPoseAndNotesDoNotCount) {
  Document document = full_document();
  const auto state = DocumentHasher()(document);
  on_model(document, [](Model& m) {
    m.pose[0] = 0.75;
    m.notes.emplace_back("something was left out");
  });
  document.pose[1] = -0.0;
  EXPECT_EQ(DocumentHasher()(document), state);
}

TEST(DocumentHash, AHasherThatHasSeenOthersAgreesWithAFreshOne) {
  DocumentHasher used;
  const Document document = full_document();
  EXPECT_EQ(used(document), DocumentHasher()(document));
  for (const Change& change : changes()) {
    Document other = document;
    change.make(other);
    EXPECT_EQ(used(other), DocumentHasher()(other)) << change.what;
    if (change.part == std::string_view("keys")) {
      EXPECT_EQ(used(document), DocumentHasher()(document)) << change.what;
    }
  }
  // Another model altogether and back again.
  EXPECT_EQ(used(make_document(tests::sheet_model())), DocumentHasher()(make_document(tests::sheet_model())));
  EXPECT_EQ(used(document), DocumentHasher()(document));
}

TEST(DocumentHash, CurvesThatComeGoAndChangePlacesAreHashedAsByAFreshOne) {
  Document document = full_document();
  while (document.curves.size() < 9) {
    PoseCurve curve = *document.curves[0];
    curve.id.value = ++document.last_curve;
    document.curves.push_back(std::make_shared<const PoseCurve>(std::move(curve)));
  }
  DocumentHasher used;
  tests::SplitMix random(3);
  const auto all = document.curves;
  for (int i = 0; i < 300; ++i) {
    for (std::size_t k = 0; k < 1 + random.below(3); ++k) {
      auto& curves = document.curves;
      const auto at = curves.begin() + static_cast<std::ptrdiff_t>(random.below(curves.size() + 1));
      if (random.chance(0.4)) {
        curves.insert(at, all[random.below(all.size())]);
      } else if (at != curves.end() && random.chance(0.5)) {
        curves.erase(at);
      } else if (at != curves.end()) {
        *at = std::make_shared<const PoseCurve>(**at);
      }
    }
    ASSERT_EQ(used(document), DocumentHasher()(document)) << i;
  }
}

TEST(DocumentHash, AModelAloneIsADocumentThatNothingWasDoneTo) {
  EXPECT_EQ(state_hash(tests::sheet_model()), DocumentHasher()(make_document(tests::sheet_model())).whole);
}

}  // namespace
}  // namespace penpose::document
