#include "ui/app/controls/control_groups.h"

#include <gtest/gtest.h>

#include "tests/support/models/sheet_model.h"

namespace penpose::app {
namespace {

TEST(ControlGroups, TheEarliestWordThatNamesAPartTellsTheGroup) {
  const auto of = [](const char* words) { return group_of_words(words, "shape_7"); };
  EXPECT_EQ(of("inner brows raised"), ControlGroup::brows);
  EXPECT_EQ(of("lower lid raised"), ControlGroup::eyes);
  EXPECT_EQ(of("eye looks up and down"), ControlGroup::eyes);
  EXPECT_EQ(of("upper lip rolls in"), ControlGroup::mouth);
  EXPECT_EQ(of("smile"), ControlGroup::mouth);
  EXPECT_EQ(of("cheek raised and eye narrows"), ControlGroup::cheeks_and_nose);
  EXPECT_EQ(of("nostrils widen"), ControlGroup::cheeks_and_nose);
  EXPECT_EQ(of("jaw opens"), ControlGroup::jaw);
  EXPECT_EQ(of("neck turns"), ControlGroup::head);
  EXPECT_EQ(of("upper arm raises"), ControlGroup::body);
  EXPECT_EQ(of("alarming wheel"), ControlGroup::others) << "a part of a word names nothing";
}

TEST(ControlGroups, SoundsAndFeelingsAreGroupsOfTheirOwn) {
  EXPECT_EQ(group_of_words("mouth: aa", "viseme_aa"), ControlGroup::mouth_shapes);
  EXPECT_EQ(group_of_words("mouth opens", "viseme_O"), ControlGroup::mouth_shapes);
  EXPECT_EQ(group_of_words("joy", "Joy"), ControlGroup::expressions);
  EXPECT_GT(ControlGroup::mouth_shapes, ControlGroup::body) << "they come after the parts";
}

TEST(ControlGroups, WhatHasNoWordsGoesByWhatItMovesAndJointsToTheBody) {
  const document::Document document = document::make_document(tests::sheet_model());
  const auto parameters = document.model->rig->parameters();
  std::vector<document::ControlWords> words;
  for (const auto& parameter : parameters) words.push_back({{parameter.name}});
  std::vector<FacePart> parts(parameters.size(), FacePart::all);
  parts[0] = FacePart::eyes;
  const auto groups = control_groups(document, words, parts);
  ASSERT_EQ(groups.size(), parameters.size());
  EXPECT_EQ(groups[0], ControlGroup::eyes);
  EXPECT_EQ(groups[rig::find_parameter(parameters, "base.ry").value()], ControlGroup::body);
}

}  // namespace
}  // namespace penpose::app
