#include "ui/render/ghosts/ghost_faces.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

#include "core/character/demo_head.h"
#include "core/document/commands/apply.h"
#include "core/drawing/editor.h"
#include "ui/render/appearance.h"
#include "ui/render/cpu/ghost_veil.h"
#include "ui/render/ghosts/ghost_drawings.h"

// The face at other moments: what is found of it, what is kept, and how it is drawn.

namespace penpose::render {
namespace {

const document::Model& demo() {
  static const document::Model model = character::make_demo_head().value();
  return model;
}

/// The built-in head with its mouth shut, open and shut, a second apart, looked at from its front.
class Ghosted {
 public:
  Ghosted() {
    for (const double time_s : {0.0, 1.0, 2.0}) {
      perform(document::SetParameters{{{"jaw", time_s == 1.0 ? 0.8 : 0.0}}});
      perform(document::SetKey{time_s, {}});
    }
    perform(document::GoToTime{1});
  }
  void perform(const document::Command& command) {
    auto changed = document::apply(document, command, work);
    ASSERT_TRUE(changed) << changed.error().line();
    document = std::move(changed).value();
  }
  void look(const GhostLook& how = {}) {
    faces.look_at({document, document::features_of(document, work), view, document.time_s, 24}, how);
  }
  [[nodiscard]] std::vector<CurveDrawing> drawings(const GhostInk& ink = {}) {
    document::Model model = *document.model;
    model.pose = document.pose;
    return ghost_drawings(faces.ghosts(), posed_mesh(model).positions, camera(), ink);
  }
  [[nodiscard]] geometry::Camera camera() const { return geometry::Camera::make(view.camera, view.viewport).value(); }

  document::Document document = document::make_document(demo());
  document::ApplyWorkspace work;
  document::View view = drawing::opening_view(document);
  GhostFaces faces;
};

TEST(GhostFaces, EachHasItsContoursAndTheFeaturesOfTheFaceAsTheyAreThen) {
  Ghosted head;
  head.look();
  ASSERT_EQ(head.faces.ghosts().size(), 2U);
  for (const Ghost& ghost : head.faces.ghosts()) {
    EXPECT_EQ(ghost.pose, document::pose_at(head.document, ghost.moment.time_s));
    std::set<std::string> features;
    bool contours = false;
    for (const GhostLine& line : ghost.lines) {
      EXPECT_EQ(line.places.size(), line.on.size());
      if (!line.feature.empty()) features.insert(line.feature);
      contours |= line.is_contour();
    }
    EXPECT_TRUE(contours);
    EXPECT_GT(features.size(), 6U) << "lips, lids and brows";
  }
}

TEST(GhostFaces, NothingIsFoundAnewWhileNothingChanges) {
  Ghosted head;
  head.look();
  const auto posed = head.faces.posed(), traced = head.faces.traced(), number = head.faces.number();
  EXPECT_EQ(posed, 2U);
  for (int i = 0; i < 5; ++i) head.look();
  EXPECT_EQ(head.faces.posed(), posed);
  EXPECT_EQ(head.faces.traced(), traced);
  EXPECT_EQ(head.faces.number(), number);
  head.view.camera.eye.x += 0.1;
  head.look();
  EXPECT_EQ(head.faces.posed(), posed) << "another view needs no other surfaces";
  EXPECT_EQ(head.faces.traced(), traced) << "and while it moves, lines go along";
  EXPECT_FALSE(head.faces.settled());
  head.look();
  EXPECT_EQ(head.faces.traced(), traced + 2) << "when it rests, there are other contours";
  EXPECT_TRUE(head.faces.settled());
  head.perform(document::GoToTime{1.5});
  head.look();
  EXPECT_EQ(head.faces.posed(), posed + 1) << "the key before is another one, and the one after stays";
  EXPECT_EQ(head.faces.traced(), traced + 3);
  head.faces.forget();
  EXPECT_TRUE(head.faces.ghosts().empty());
}

TEST(GhostFaces, WhatLiesWhereTheFaceIsNowIsNotDrawn) {
  Ghosted head;
  head.look();
  const auto open = head.drawings();
  ASSERT_FALSE(open.empty());
  const auto camera = head.camera();
  double highest = 1e9;
  for (const CurveDrawing& line : open) {
    for (const auto& point : line.points) highest = std::min(highest, camera.project(point)->y);
  }
  double brow = 1e9;
  for (const GhostLine& line : head.faces.ghosts().front().lines) {
    if (line.feature.find("brow") != std::string::npos) brow = std::min(brow, line.places.front().y);
  }
  EXPECT_GT(highest, brow) << "the jaw opens, and the brows are as they were";
  // A face that is as at the keys around it has nothing beside itself.
  head.perform(document::SetParameters{{{"jaw", 0}}});
  head.look();
  EXPECT_TRUE(head.drawings().empty());
}

TEST(GhostFaces, TheyFadeWithTheirDistanceAndTellBeforeFromAfter) {
  EXPECT_GT(ghost_color({0, -1}).a, ghost_color({0, -2}).a);
  EXPECT_GT(ghost_color({0, 2}).a, ghost_color({0, 3}).a);
  EXPECT_EQ(ghost_color({0, -1}).r, from_srgb(k_before_color).r);
  EXPECT_EQ(ghost_color({0, 2}).b, from_srgb(k_after_color).b);
}

TEST(GhostFaces, TheNearestLineOfTheNearestMomentIsFound) {
  Ghosted head;
  GhostLook look;
  look.before = 2;
  head.perform(document::GoToTime{2});
  head.perform(document::SetKey{3, {}});
  head.perform(document::GoToTime{3});
  head.look(look);
  ASSERT_EQ(head.faces.ghosts().size(), 2U);
  // Where both moments have their brows together, the nearer moment is meant.
  const auto& lines = head.faces.ghosts()[0].lines;
  const auto brow = std::find_if(lines.begin(), lines.end(),
                                 [](const GhostLine& line) { return line.feature.find("brow") != std::string::npos; });
  ASSERT_NE(brow, lines.end());
  const auto found = ghost_near(head.faces.ghosts(), brow->places[brow->places.size() / 2], 20);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->ghost, 1U);
  EXPECT_EQ(head.faces.ghosts()[1].lines[found->line].feature, brow->feature);
  EXPECT_FALSE(ghost_near(head.faces.ghosts(), {2, 2}, 20));
}

TEST(GhostVeil, IsTintedWhereAFaceWasAndClearWhereNothingMoves) {
  Ghosted head;
  GhostLook look;
  look.after = 0;
  head.look(look);
  ASSERT_EQ(head.faces.ghosts().size(), 1U);
  document::Model model = *head.document.model;
  model.pose = head.document.pose;
  const auto now = posed_mesh(model).positions;
  const Appearance appearance = make_appearance(model);
  GhostVeil draws;
  const auto veil = draws.draw(head.faces.ghosts(), {*model.mesh, appearance, 1, now}, head.camera(), {});
  ASSERT_NE(veil, nullptr);
  EXPECT_EQ(veil->width, (head.view.viewport.width + 1) / 2);
  const auto px_at = [&](const std::string& feature) {
    for (const GhostLine& line : head.faces.ghosts().front().lines) {
      if (line.feature.find(feature) == std::string::npos) continue;
      const auto place = line.places[line.places.size() / 2];
      return veil->at(static_cast<int>(place.x / 2), static_cast<int>(place.y / 2));
    }
    return veil->at(0, 0);
  };
  EXPECT_GT(px_at("lip_lower")[3], 60) << "one sees it";
  EXPECT_LT(px_at("lip_lower")[3], 200) << "and through it";
  EXPECT_GT(px_at("lip_lower")[2], px_at("lip_lower")[1]) << "violet is before";
  EXPECT_EQ(px_at("brow")[3], 0);
  // As it lies over a picture of the face.
  Image picture;
  picture.width = head.view.viewport.width;
  picture.height = head.view.viewport.height;
  picture.pixels.assign(4 * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height), 200);
  lay_veil(*veil, picture);
  EXPECT_EQ(picture.at(0, 0)[1], 200);
  EXPECT_TRUE(std::any_of(picture.pixels.begin(), picture.pixels.end(), [](std::uint8_t v) { return v < 190; }));
  // Nothing of a face that is as it was.
  EXPECT_EQ(draws.draw(head.faces.ghosts(), {*model.mesh, appearance, 1, head.faces.ghosts().front().positions},
                       head.camera(), {}),
            nullptr);
}

}  // namespace
}  // namespace penpose::render
