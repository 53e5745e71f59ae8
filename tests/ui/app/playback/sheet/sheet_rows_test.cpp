#include "ui/app/playback/sheet/sheet_rows.h"

#include <gtest/gtest.h>

#include "tests/support/document_hand.h"

namespace penpose::app {
namespace {

std::vector<std::string> names(const std::vector<SheetRow>& rows) {
  std::vector<std::string> out;
  for (const SheetRow& row : rows) out.push_back((row.group ? "[" : "") + row.name);
  return out;
}

/// Words that are not the names.
std::vector<document::ControlWords> words_of(const tests::DocumentHand& hand) {
  std::vector<document::ControlWords> out;
  for (const auto& one : hand.document().model->rig->parameters()) out.push_back({{"does " + one.name}});
  return out;
}

TEST(SheetRows, ListWhatIsKeyedAwayFromRestByItsPart) {
  tests::DocumentHand hand;
  hand.does(document::SetParameters{{{"lift", 0.5}}});
  hand.does(document::SetKey{0, ""});
  std::vector<FacePart> parts(hand.document().pose.size(), FacePart::all);
  parts[0] = FacePart::mouth;  // lift
  parts[1] = FacePart::brows;  // lean
  EXPECT_EQ(names(sheet_rows(hand.document(), parts, words_of(hand), {}, false)),
            (std::vector<std::string>{"[Mouth", "lift"}));
  EXPECT_EQ(names(sheet_rows(hand.document(), parts, words_of(hand), {"Mouth"}, false)),
            (std::vector<std::string>{"[Mouth"}));
  const auto all = sheet_rows(hand.document(), parts, words_of(hand), {"base"}, true);
  EXPECT_EQ(names(all), (std::vector<std::string>{"[Brows", "lean", "[Mouth", "lift", "[base"})) << "a limb of joints";
  EXPECT_EQ(all[1].shown, "does lean") << "what it does stands there";
  EXPECT_EQ(all.back().controls.size(), 3U) << "a folded group still stands for its controls";
}

TEST(SheetRows, AControlWithoutAKeyHasNone) {
  tests::DocumentHand hand;
  hand.does(document::SetParameters{{{"lift", 0.5}, {"lean", 0.5}}});
  hand.does(document::SetKey{0, "", {"lift"}});
  const std::vector<FacePart> parts(hand.document().pose.size(), FacePart::all);
  EXPECT_EQ(names(sheet_rows(hand.document(), parts, words_of(hand), {}, true)),
            (std::vector<std::string>{"[Others", "lift"}));
}

}  // namespace
}  // namespace penpose::app
