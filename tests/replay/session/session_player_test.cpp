#include "replay/session/session_player.h"

#include <gtest/gtest.h>

#include "replay/session/session_recorder.h"
#include "tests/support/random_session.h"

namespace penpose::replay {
namespace {

PlayerOptions options() {
  PlayerOptions out;
  out.open = [](const std::string& path) -> base::Result<document::Document> {
    if (path.empty() || path == "sheet") return document::make_document(tests::sheet_model());
    return base::Error{"cannot be opened", "", ""};
  };
  return out;
}

base::Result<ReplayResult> play(const std::string& text, const PlayerOptions& with = options()) {
  return play_session(read_from(base::as_bytes(text)), with);
}

std::vector<geometry::PxPoint> line(geometry::PxPoint from, geometry::PxPoint to) {
  std::vector<geometry::PxPoint> out;
  for (int i = 0; i <= 10; ++i) out.push_back(from + (to - from) * (i / 10.0));
  return out;
}

tests::SessionScript small_session() {
  tests::SessionScript script(document::make_document(tests::sheet_model()), "sheet");
  EXPECT_TRUE(script.stroke(line({350, 300}, {650, 300})));
  EXPECT_TRUE(script.stroke(line({350, 220}, {650, 240})));
  EXPECT_TRUE(script.perform(document::SetKey{1, "up"}));
  return script;
}

TEST(SessionPlayer, EndsInTheStateThatWasRecorded) {
  const auto script = small_session();
  const auto played = play(script.text());
  ASSERT_TRUE(played);
  EXPECT_FALSE(played->plain);
  EXPECT_EQ(played->program, "penpose-test");
  EXPECT_EQ(played->session->stroke_count(), 2U);
  EXPECT_EQ(played->checked, 3U);
  EXPECT_FALSE(played->divergence);
  const document::Document& document = played->session->editor().document();
  EXPECT_EQ(played->session->editor().state(), document::DocumentHasher()(script.document()));
  EXPECT_GT(document.pose[0], 0.1) << "the sheet followed the pen";
  ASSERT_EQ(document.timeline->keys.size(), 1U);
  EXPECT_EQ(document.timeline->keys[0].name, "up");
}

TEST(SessionPlayer, IsAPlainTraceForEverybodyElse) {
  const auto script = small_session();
  TraceSource source(read_from(base::as_bytes(script.text())));
  std::size_t reports = 0;
  for (auto report = source.next(); report && *report; report = source.next()) ++reports;
  EXPECT_EQ(reports, 2U * (11 + 3));
  EXPECT_TRUE(source.problems().empty());
  ASSERT_EQ(source.devices().size(), 1U);
  EXPECT_EQ(source.devices().at(0).name, "penpose virtual pen");
}

TEST(SessionPlayer, DrawsAPlainTraceWithTheDefaults) {
  const auto script = small_session();
  std::string plain;
  for (std::size_t begin = 0, end = 0; begin < script.text().size(); begin = end + 1) {
    end = script.text().find('\n', begin);
    if (script.text()[begin] != '#') plain += script.text().substr(begin, end + 1 - begin);
  }
  const auto played = play(plain);
  ASSERT_TRUE(played);
  EXPECT_TRUE(played->plain);
  EXPECT_EQ(played->session->stroke_count(), 2U);
  EXPECT_GT(played->session->editor().document().pose[0], 0.1);
}

TEST(SessionPlayer, ReportsTheFirstLineThatDiffersAndWhatDiffers) {
  std::string text = small_session().text();
  // The first key is set somewhere else than was recorded.
  const std::size_t key = text.find("do set_key time_s=1");
  ASSERT_NE(key, std::string::npos);
  text.replace(key, 19, "do set_key time_s=2");
  const auto played = play(text);
  ASSERT_TRUE(played);
  ASSERT_TRUE(played->divergence);
  const auto before = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(key), '\n');
  EXPECT_EQ(played->divergence->line, static_cast<std::uint64_t>(before) + 2) << "the state after that command";
  EXPECT_EQ(played->divergence->parts, (std::vector<std::string_view>{"parameters", "curves", "keys"}))
      << "lines go along with the pose that is keyed";
  EXPECT_EQ(played->differing, 1U);
}

TEST(SessionPlayer, RefusesAModelThatHasChanged) {
  const auto script = small_session();
  PlayerOptions other = options();
  other.open = [](const std::string&) -> base::Result<document::Document> {
    document::Model model = tests::sheet_model();
    model.pose[0] = 0.25;
    return document::make_document(model);
  };
  const auto played = play(script.text(), other);
  ASSERT_FALSE(played);
  EXPECT_EQ(played.error().place, "line 2");
  EXPECT_NE(played.error().what.find("is not the one that was drawn on"), std::string::npos);
  EXPECT_NE(played.error().remedy.find("--model"), std::string::npos);
}

// Somebody goes on with a project that has curves, keys and views.
TEST(SessionPlayer, GoesOnWithAProject) {
  auto before = small_session();
  ASSERT_TRUE(before.perform(document::SaveView{"front", before.editor().view()}));
  const document::Document project = before.document();
  tests::SessionScript after(project, "project");
  EXPECT_TRUE(after.stroke(line({300, 600}, {700, 600})));
  PlayerOptions opening = options();
  opening.open = [&](const std::string&) -> base::Result<document::Document> { return project; };
  const auto played = play(after.text(), opening);
  ASSERT_TRUE(played) << played.error().line();
  EXPECT_FALSE(played->divergence);
  EXPECT_EQ(played->session->editor().document().curves.size(), 2U);
}

TEST(SessionPlayer, RefusesAModelThatIsMissing) {
  std::string text = small_session().text();
  text.replace(text.find("path=sheet"), 10, "path=gone");
  const auto played = play(text);
  ASSERT_FALSE(played);
  EXPECT_EQ(played.error().place, "line 2");
}

TEST(SessionPlayer, RefusesAnotherVersionByName) {
  std::string text = small_session().text();
  text.replace(text.find("edition=11"), 10, "edition=1");
  const auto played = play(text);
  ASSERT_FALSE(played);
  EXPECT_EQ(played.error().place, "line 1");
  EXPECT_NE(played.error().what.find("another edition"), std::string::npos);
}

TEST(SessionPlayer, StopsAfterAStroke) {
  PlayerOptions some = options();
  some.stop_after_strokes = 1;
  const auto played = play(small_session().text(), some);
  ASSERT_TRUE(played);
  EXPECT_EQ(played->session->editor().document().curves.size(), 1U);
  EXPECT_EQ(played->session->editor().document().pose[0], 0.0);
}

TEST(SessionPlayer, WaitsInRealTime) {
  PlayerOptions slow = options();
  slow.pace = Pace::real_time;
  std::vector<std::int64_t> waits;
  slow.wait = [&](std::int64_t after_us) { waits.push_back(after_us); };
  ASSERT_TRUE(play(small_session().text(), slow));
  ASSERT_GT(waits.size(), 20U);
  EXPECT_TRUE(std::is_sorted(waits.begin(), waits.end()));
}

// Cut off at any byte, a session gives all that had ended before: the state of the longest prefix of whole lines.
TEST(SessionPlayer, AFileCutAtAnyByteGivesItsLongestWholePrefix) {
  const std::string text = small_session().text();
  std::string last_state = "nothing";
  std::size_t last_line_end = 0;
  for (std::size_t length = 0; length <= text.size(); ++length) {
    const auto played = play(text.substr(0, length));
    ASSERT_TRUE(played) << "cut at byte " << length << ": " << played.error().line();
    EXPECT_FALSE(played->divergence) << "cut at byte " << length;
    const std::string state = played->session ? played->session->editor().state().whole.hex() : "nothing";
    if (length > 0 && text[length - 1] == '\n') last_line_end = length;
    const auto whole = play(text.substr(0, last_line_end));
    const std::string whole_state = whole->session ? whole->session->editor().state().whole.hex() : "nothing";
    // A last report whose bytes are all there counts, though its line end is missing.
    if (state != whole_state) {
      const auto with_end = play(text.substr(0, length) + "\n");
      ASSERT_TRUE(with_end);
      EXPECT_EQ(state, with_end->session->editor().state().whole.hex()) << "cut at byte " << length;
    }
  }
}

TEST(SessionPlayer, ALineThatIsTooLongIsLeftOutAndToldOnce) {
  std::string text = small_session().text();
  const std::size_t end = text.find("# penpose do set_key");
  // Its last piece alone would be a command.
  const std::string line = "#" + std::string(3 * TraceReader::k_longest_line - 1, '#') + "# penpose undo\n";
  const auto played = play(text.substr(0, end) + line + text.substr(end));
  ASSERT_TRUE(played);
  EXPECT_FALSE(played->divergence);
  EXPECT_EQ(played->steps, 3U);
  ASSERT_EQ(played->problems.size(), 1U);
  EXPECT_NE(played->problems[0].what.find("too long"), std::string::npos) << played->problems[0].line();
  EXPECT_EQ(
      played->problems[0].place,
      "line " + std::to_string(1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n')));
}

TEST(SessionRecorder, MakesASessionOfAPlainTraceThatReplaysToTheSameState) {
  const auto script = small_session();
  std::string text;
  SessionWriter writer(
      [&](std::string_view piece, bool) -> base::Status {
        text += piece;
        return base::Done{};
      },
      "again");
  SessionRecorder recorder(writer);
  PlayerOptions recording = options();
  recording.observer = &recorder;
  const auto first = play(script.text(), recording);
  ASSERT_TRUE(first);
  ASSERT_TRUE(writer.flush(true));
  const auto second = play(text);
  ASSERT_TRUE(second);
  EXPECT_EQ(second->program, "again");
  EXPECT_FALSE(second->divergence);
  EXPECT_EQ(second->checked, 3U);
  EXPECT_EQ(second->session->editor().state(), first->session->editor().state());
}

TEST(SessionWriter, ADiskThatIsFullLeavesTheDocumentAlive) {
  std::size_t room = 600;
  SessionWriter writer(
      [&](std::string_view piece, bool) -> base::Status {
        if (piece.size() > room) return base::Error{"the disk is full", "", ""};
        room -= piece.size();
        return base::Done{};
      },
      "test");
  LiveSession live(document::make_document(tests::sheet_model()), &writer, "sheet");
  for (int i = 1; i <= 20; ++i) {
    EXPECT_TRUE(live.act(Performed{document::SetParameters{{{"lift", i * 0.01}}}}, i));
  }
  ASSERT_TRUE(writer.broken());
  EXPECT_EQ(writer.broken()->what, "the disk is full");
  EXPECT_EQ(live.session().editor().document().pose[0], 0.2);
}

TEST(SessionWriter, WhatTheDiskDidNotTakeComesWithWhatIsNext) {
  bool full = false;
  std::string text;
  SessionWriter writer(
      [&](std::string_view piece, bool) -> base::Status {
        if (full) return base::Error{"the disk is full", "", ""};
        text += piece;
        return base::Done{};
      },
      "test");
  LiveSession live(document::make_document(tests::sheet_model()), &writer, "sheet");
  for (int i = 1; i <= 20; ++i) {
    full = i > 5 && i < 15;
    EXPECT_TRUE(live.act(Performed{document::SetParameters{{{"lift", i * 0.01}}}}, i));
    EXPECT_EQ(writer.broken().has_value(), full);
  }
  PlayerOptions options;
  options.open = [](const std::string&) { return document::make_document(tests::sheet_model()); };
  const auto played = play_session(read_from(base::as_bytes(text)), options);
  ASSERT_TRUE(played && played->session);
  EXPECT_FALSE(played->divergence);
  EXPECT_EQ(played->checked, 20U);
  EXPECT_EQ(played->session->editor().state(), live.session().editor().state());
}

}  // namespace
}  // namespace penpose::replay
