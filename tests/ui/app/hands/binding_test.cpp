#include "ui/app/hands/binding.h"

#include <gtest/gtest.h>
#include <set>

#include "ui/app/hands/hand_desk.h"

namespace penpose::app {
namespace {

decode::PadFeatures pad(unsigned keys, unsigned mode_key = 64) {
  decode::PadFeatures has;
  has.keys = decode::numbered_keys(~0ULL, keys);
  if (mode_key < 64) has.mode_keys = {decode::numbered_key(mode_key)};
  return has;
}

Binding of_key(const decode::PadFeatures& has, unsigned number) {
  return default_binding(key_control(decode::numbered_key(number)), has);
}

TEST(Binding, EveryoneIsReadAsItIsWritten) {
  std::vector<Binding> all(held_choices().begin(), held_choices().end());
  all.insert(all.end(), dial_choices().begin(), dial_choices().end());
  for (const ActionInfo& one : all_actions()) all.push_back(binding_of(one.action));
  for (const auto kind : {Binding::Kind::none, Binding::Kind::pen_menu, Binding::Kind::next_mode}) {
    all.push_back({});
    all.back().kind = kind;
  }
  std::set<std::string> texts;
  for (const Binding& one : all) {
    EXPECT_TRUE(texts.insert(to_text(one)).second) << to_text(one) << " twice";
    ASSERT_TRUE(parse_binding(to_text(one))) << to_text(one);
    EXPECT_EQ(*parse_binding(to_text(one)), one);
    EXPECT_FALSE(label_of(one).empty());
  }
  for (const char* wrong : {"", "action", "action Fly", "hold", "tool Rig", "dial time ", "Undo"})
    EXPECT_FALSE(parse_binding(wrong)) << wrong;
}

TEST(DefaultBinding, FewKeysDoWhatIsWantedMost) {
  EXPECT_EQ(of_key(pad(1), 0), binding_of(Action::undo));
  EXPECT_EQ(of_key(pad(2), 1), binding_of(Action::redo));
  EXPECT_EQ(of_key(pad(4), 2), binding_of(ViewHold::turn));
  EXPECT_EQ(of_key(pad(4), 3), binding_of(ViewHold::move));
  EXPECT_EQ(of_key(pad(8), 4), binding_of(drawing::ToolKind::erase));
}

TEST(DefaultBinding, TheKeyThatMovesTheLightDoesNothingElseAndTakesNoPlace) {
  EXPECT_EQ(of_key(pad(7, 0), 0), Binding{});
  EXPECT_EQ(of_key(pad(7, 0), 1), binding_of(Action::undo));
  EXPECT_EQ(of_key(pad(9, 8), 0), binding_of(Action::undo)) << "where it is the last one";
}

TEST(ModeKey, EachDialHasItsOwnAndOfSeveralEachChoosesALight) {
  decode::PadFeatures has = pad(18);
  has.modes = 2;
  has.mode_keys = {decode::numbered_key(0), decode::numbered_key(9)};
  EXPECT_FALSE(mode_key(decode::numbered_key(1), has));
  EXPECT_EQ(mode_key(decode::numbered_key(0), has)->side, 0);
  EXPECT_EQ(mode_key(decode::numbered_key(9), has)->side, 1);
  EXPECT_EQ(mode_key(decode::numbered_key(9), has)->light, -1);
  has.mode_keys = 0;
  for (const unsigned i : {0U, 1U, 2U, 8U, 9U, 10U}) has.mode_keys.set(decode::numbered_key(i));
  EXPECT_EQ(mode_key(decode::numbered_key(2), has)->side, 0);
  EXPECT_EQ(mode_key(decode::numbered_key(2), has)->light, 2);
  EXPECT_EQ(mode_key(decode::numbered_key(8), has)->side, 1);
  EXPECT_EQ(mode_key(decode::numbered_key(8), has)->light, 0);
}

TEST(DefaultBinding, NoTwoKeysOfALargePadDoTheSame) {
  std::set<std::string> texts;
  for (unsigned i = 0; i < 20; ++i) EXPECT_TRUE(texts.insert(to_text(of_key(pad(20), i))).second) << i;
}

TEST(DefaultBinding, EachLightOfARingIsAnotherValueAndASecondRingBeginsElsewhere) {
  std::set<std::string> texts;
  for (std::int8_t light = 0; light < 4; ++light)
    texts.insert(to_text(default_binding(dial_control(decode::PadDial::ring, 0, light), {})));
  EXPECT_EQ(texts.size(), 4U);
  EXPECT_EQ(default_binding(dial_control(decode::PadDial::ring, 0, 0), {}), binding_of(DialUse::time));
  EXPECT_NE(default_binding(dial_control(decode::PadDial::ring, 1, 0), {}), binding_of(DialUse::time));
}

TEST(TabletKey, OverBluetoothATabletIsTheSameOne) {
  decode::DeviceIdentity identity;
  identity.vendor = 0x056a;
  identity.product = 0x0360;
  identity.bus = decode::k_bus_bluetooth;
  identity.name = "Intuos Pro M";
  const std::string wireless = tablet_key(identity);
  identity.product = 0x0357;
  identity.bus = decode::k_bus_usb;
  identity.name = "Wacom Co.,Ltd. Intuos Pro M";
  EXPECT_EQ(tablet_key(identity), wireless);
  identity.product = 0x0358;
  EXPECT_NE(tablet_key(identity), wireless);
  identity.vendor = 0x9999;
  identity.name = "a|b=c\nd";
  EXPECT_EQ(tablet_key(identity), "9999:0358 a b c d") << "so that a line of the settings stays one";
}

}  // namespace
}  // namespace penpose::app
