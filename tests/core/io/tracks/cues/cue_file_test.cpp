#include "core/io/tracks/cues/cue_file.h"

#include <gtest/gtest.h>

#include "core/base/numbers.h"
#include "core/io/tracks/track_formats.h"

namespace penpose::io {
namespace {

constexpr std::string_view k_dictionary = "ma M AA1\noh OW1\nhello HH AH0 L OW1\nfive F AY1 V\n";

CueFile cues_of(std::string_view text) {
  auto read = read_cues(base::as_bytes(text), base::as_bytes(k_dictionary));
  EXPECT_TRUE(read) << (read ? "" : read.error().line()) << "\n" << text;
  return read ? *std::move(read) : CueFile();
}

/// The shape at a time.
std::string shape_at(const CueFile& cues, double time_s) {
  std::string shape = "none";
  for (const CueFile::Cue& cue : cues.list) {
    if (cue.start_s <= time_s + 1e-9) shape = cue.shape;
  }
  return shape;
}

std::string shapes_at(const CueFile& cues, std::initializer_list<double> times) {
  std::string all;
  for (const double time : times) all += shape_at(cues, time);
  return all;
}

std::string words_in(const CueFile& cues) {
  std::string all;
  for (const auto& word : cues.words) all += word.word + "@" + base::format_fixed(word.from_s, 2) + " ";
  return all;
}

std::string wide(std::string_view text, bool little) {
  std::string out = little ? "\xff\xfe" : "\xfe\xff";
  for (const char c : text) out += little ? std::string{c, '\0'} : std::string{'\0', c};
  return out;
}

/// "words" with ma and oh, "phones" with M AA1 (a pause) OW1.
std::string textgrid(bool is_long, std::string_view phones = "M AA1 sil OW1") {
  struct Label {
    const char* from;
    const char* to;
    std::string text;
  };
  std::vector<Label> said{{"0.5", "0.6", ""}, {"0.6", "1", ""}, {"1", "1.5", ""}, {"1.5", "2", ""}};
  for (Label& one : said) {
    const std::size_t gap = std::min(phones.find(' '), phones.size());
    one.text = phones.substr(0, gap);
    phones.remove_prefix(std::min(gap + 1, phones.size()));
  }
  const std::vector<std::pair<std::string, std::vector<Label>>> tiers{
      {"words", {{"0", "0.5", ""}, {"0.5", "1", "ma"}, {"1", "1.5", ""}, {"1.5", "2", "oh"}}}, {"phones", said}};
  std::string out = is_long ? "File type = \"ooTextFile\"\nObject class = \"TextGrid\"\n\nxmin = 0\nxmax = 2\ntiers? "
                              "<exists>\nsize = 2\nitem []:\n"
                            : "File type = \"ooTextFile\"\nObject class = \"TextGrid\"\n\n0\n2\n<exists>\n2\n";
  int number = 0;
  for (const auto& [name, labels] : tiers) {
    const std::string count = std::to_string(labels.size());
    out += is_long
               ? "    item [" + std::to_string(++number) + "]:\n        class = \"IntervalTier\"\n        name = \"" +
                     name + "\"\n        xmin = 0\n        xmax = 2\n        intervals: size = " + count + "\n"
               : "\"IntervalTier\"\n\"" + name + "\"\n0\n2\n" + count + "\n";
    for (const Label& label : labels) {
      out += is_long ? std::string("        intervals [1]:\n            xmin = ") + label.from +
                           "\n            xmax = " + label.to + "\n            text = \"" + label.text + "\"\n"
                     : std::string(label.from) + "\n" + label.to + "\n\"" + label.text + "\"\n";
    }
  }
  return out;
}

TEST(CueFile, ATextGridIsReadLongAndShortAsUtf8AndUtf16) {
  for (const bool is_long : {true, false}) {
    for (const std::string& text : {textgrid(is_long), wide(textgrid(is_long), true), wide(textgrid(is_long), false)}) {
      const CueFile cues = cues_of(text);
      EXPECT_EQ(shapes_at(cues, {0.2, 0.55, 0.8, 1.2, 1.7, 2.1}), "XADXEX");
      EXPECT_EQ(words_in(cues), "ma@0.50 oh@1.50 ");
      EXPECT_NEAR(cues.end_s, 2, 1e-9);
    }
  }
  EXPECT_EQ(format_of_track(base::as_bytes(textgrid(true)))->name, "cues");
  const auto track = read_track(base::as_bytes(wide(textgrid(true), true)), nullptr, {});
  ASSERT_TRUE(track);
  EXPECT_EQ(track->format->name, "cues");
}

TEST(CueFile, PhonesOfATextGridMayBeIpaAndUnknownOnesAreSpokenByTheirWords) {
  EXPECT_EQ(shapes_at(cues_of(textgrid(true, "m ɑː  oʊ")), {0.55, 0.8, 1.2, 1.7}), "ADXE");
  EXPECT_EQ(shapes_at(cues_of(textgrid(true, "M AA1 sil spn")), {0.55, 0.8, 1.2, 1.7}), "ADXE") << "oh of the words";
}

TEST(CueFile, AnotherFileOfPraatIsNamed) {
  const auto place = [](const std::string& text) { return read_cues(base::as_bytes(text)).error(); };
  EXPECT_EQ(
      place("File type = \"ooTextFile\"\nObject class = \"TextGrid\"\n\nxmin = 0\nxmax = 2\ntiers? <exists>\n"
            "size = 1\nitem []:\nclass = \"IntervalTier\" name = \"words\" xmin = 0 xmax = 2 intervals: size = 2\n"
            "xmin = 0 xmax = nothing\n")
          .place,
      "line 11");
  EXPECT_NE(place(textgrid(true).substr(0, 200)).remedy.find("Praat"), std::string::npos);
}

TEST(CueFile, PapagayosProjectsHaveTheirOwnRate) {
  const CueFile cues = cues_of(
      "lipsync version 1\nma.wav\n24\n72\n1\n\tVoice 1\n\tma oh\n\t2\n\t\tma\n\t\t12\n\t\t23\n\t\t1\n\t\t\tma 12 23 2\n"
      "\t\t\t\t12 MBP\n\t\t\t\t18 AI\n\t\toh\n\t\t36\n\t\t47\n\t\t1\n\t\t\toh 36 47 1\n\t\t\t\t36 O\n");
  EXPECT_TRUE(cues.blair);
  EXPECT_EQ(shape_at(cues, 0.6), "MBP");
  EXPECT_EQ(shape_at(cues, 0.9), "AI");
  EXPECT_EQ(shape_at(cues, 1.2), "rest");
  EXPECT_EQ(shape_at(cues, 1.6), "O");
  EXPECT_EQ(words_in(cues), "ma@0.50 oh@1.50 ");
  EXPECT_NEAR(cues.end_s, 3, 1e-9);
  const CueFile json = cues_of(
      R"({"version": 2, "fps": 24, "sound_duration": 72, "num_voices": 1, "voices": [{"name": "a", "phrases": [
          {"start_frame": 12, "end_frame": 23, "words": [{"text": "ma", "start_frame": 12, "end_frame": 23, "phonemes": [
              {"text": "M", "frame": 12}, {"text": "AA", "frame": 18}]}]}]}]})");
  EXPECT_EQ(shapes_at(json, {0.2, 0.55, 0.8, 1.2}), "XADX");
  EXPECT_EQ(read_cues(base::as_bytes("lipsync version 1\na\n24\n9\n1\nv\nt\n1\np\n1\n9\n1\nword 1 9\n")).error().place,
            "line 13");
}

TEST(CueFile, PollysMarksAreMilliseconds) {
  const CueFile cues = cues_of(
      "{\"time\":0,\"type\":\"sentence\",\"start\":0,\"end\":9,\"value\":\"Ma, oh.\"}\n"
      "{\"time\":500,\"type\":\"word\",\"start\":0,\"end\":2,\"value\":\"Ma\"}\n"
      "{\"time\":500,\"type\":\"viseme\",\"value\":\"p\"}\n{\"time\":600,\"type\":\"viseme\",\"value\":\"a\"}\n"
      "{\"time\":1000,\"type\":\"viseme\",\"value\":\"sil\"}\n{\"time\":1500,\"type\":\"viseme\",\"value\":\"o\"}\n");
  EXPECT_EQ(shapes_at(cues, {0.55, 0.8, 1.2, 1.7}), "ADXE");
  EXPECT_EQ(words_in(cues), "Ma@0.50 ");
  // Marks of words alone are spoken.
  const CueFile words = cues_of(
      "{\"time\":500,\"type\":\"word\",\"start\":0,\"end\":2,\"value\":\"ma\"}\n"
      "{\"time\":700,\"type\":\"word\",\"start\":3,\"end\":5,\"value\":\"oh\"}\n");
  EXPECT_EQ(shapes_at(words, {0.55, 0.65, 0.75, 0.9}), "ADEX");
}

TEST(CueFile, AzuresEventsAreOfAnyUnit) {
  for (const auto& [unit, name] : {std::pair("0000", "audioOffset"), {"", "audioOffset"}, {"", "audio_offset"}}) {
    std::string text = "[";
    for (const auto& [ms, viseme] : {std::pair(50, 0), {500, 21}, {600, 2}, {1000, 0}, {1500, 8}}) {
      text += (text.size() > 1 ? ", {\"" : "{\"") + std::string(name) + "\": " + std::to_string(ms) + unit +
              ", \"visemeId\": " + std::to_string(viseme) + "}";
    }
    EXPECT_EQ(shapes_at(cues_of(text + "]"), {0.2, 0.55, 0.8, 1.2, 1.7}), "XADXE") << text;
  }
  EXPECT_EQ(shapes_at(cues_of(R"({"visemes": [{"time": 0.5, "visemeId": 21}, {"time": 0.6, "visemeId": 2},
                                              {"time": 1, "visemeId": 0}]})"),
                      {0.55, 0.8, 1.2}),
            "ADX");
  EXPECT_EQ(read_cues(base::as_bytes(R"([{"audioOffset": 1, "visemeId": 99}])")).error().place, "/0");
}

TEST(CueFile, LabelsOfAudacityAreMouthsPhonesOrWords) {
  EXPECT_EQ(shapes_at(cues_of("0.5\t0.6\tA\n0.6\t1.0\tD\n1.5\t2.0\tE\n"), {0.55, 0.8, 1.2, 1.7}), "ADXE");
  EXPECT_EQ(shapes_at(cues_of("0.5\t0.6\tM\n0.6\t1.0\tAA1\n1.5\t2.0\tOW1\n"), {0.55, 0.8, 1.2, 1.7}), "ADXE");
  EXPECT_EQ(shapes_at(cues_of("0,5\t0,6\tclosed\n0,6\t1,0\tA\n1,5\t2,0\tO\n"), {0.55, 0.8, 1.2, 1.7}), "ADXE");
  const CueFile blair = cues_of("0.5\t0.6\tMBP\n0.6\t1.0\tAI\n1.5\t2.0\tO\n");
  EXPECT_EQ(shapes_at(blair, {0.55, 0.8, 1.2, 1.7}), "MBPAIrestO");
  const CueFile words = cues_of("0.5\t0.9\tma\n\\\t100\t200\n1.5\t2.0\toh\n");
  EXPECT_EQ(shapes_at(words, {0.55, 0.8, 1.2, 1.7}), "ADXE");
  EXPECT_EQ(words_in(words), "ma@0.50 oh@1.50 ");
  EXPECT_EQ(shapes_at(cues_of("start\tend\ttext\n500\t900\tma\n1500\t2000\toh\n"), {0.55, 0.8, 1.2, 1.7}), "ADXE")
      << "Whisper's milliseconds";
  EXPECT_EQ(
      shapes_at(cues_of("Begin,End,Label,Type,Speaker\n0.5,0.9,oh,words,a\n0.5,0.6,M,phones,a\n0.6,0.9,AA1,phones,a\n"),
                {0.55, 0.8, 1.2}),
      "ADX")
      << "of the Montreal Forced Aligner";
}

TEST(CueFile, CaptionsAreSpokenOverTheirTime) {
  const CueFile srt = cues_of("1\n00:00:00,500 --> 00:00:00,900\nma\n\n2\n00:00:01,500 --> 00:00:02,000\n<i>oh</i>\n");
  EXPECT_EQ(shapes_at(srt, {0.55, 0.8, 1.2, 1.7, 2.1}), "ADXEX");
  // Three words of two, one and four sounds share 0.7 s.
  const CueFile line = cues_of("WEBVTT\n\n00:01.000 --> 00:01.700 align:start\n[music] ma oh\nhello\n");
  EXPECT_EQ(words_in(line), "ma@1.00 oh@1.20 hello@1.30 ");
  EXPECT_EQ(shapes_at(line, {1.05, 1.15, 1.25}), "ADE");
  // Words with times of their own, and the next caption that repeats them.
  const CueFile timed = cues_of(
      "WEBVTT\n\n00:00.500 --> 00:02.000\nma<00:01.500><c> oh</c>\n\n"
      "00:02.000 --> 00:02.010\nma oh\n");
  EXPECT_EQ(words_in(timed), "ma@0.50 oh@1.50 ");
  // One word at a time is marked.
  const CueFile marked = cues_of(
      "1\n00:00:00,500 --> 00:00:01,000\n<u>ma</u> oh hello\n\n2\n00:00:01,500 --> 00:00:02,000\n"
      "ma <u>oh</u> hello\n\n3\n00:00:02,000 --> 00:00:03,000\nma oh <u>hello</u>\n");
  EXPECT_EQ(words_in(marked), "ma@0.50 oh@1.50 hello@2.00 ");
  EXPECT_EQ(read_cues(base::as_bytes("WEBVTT\n\nx --> 00:02.000\nma\n")).error().place, "line 3");
}

TEST(CueFile, JsonOfWordsIsReadWhereverTheyLie) {
  const std::vector<std::string> files{
      R"({"segments": [{"start": 0.5, "end": 2, "text": "ma oh", "words": [{"word": "ma", "start": 0.5, "end": 0.9,
          "score": 0.9}, {"word": "oh", "start": 1.5, "end": 2}]}], "word_segments": [{"word": "ma", "start": 0.5,
          "end": 0.9}, {"word": "oh", "start": 1.5, "end": 2}]})",
      R"({"text": "ma oh", "segments": [{"id": 0, "start": 0, "end": 2, "text": " ma oh", "tokens": [1, 2], "words": [
          {"text": " ma", "start": 0.5, "end": 0.9}, {"text": " oh", "start": 1.5, "end": 2}]}]})",
      R"({"transcript": "ma oh", "words": [{"alignedWord": "ma", "case": "success", "start": 0.5, "end": 0.9, "phones": [
          {"phone": "m_B", "duration": 0.1}, {"phone": "aa_E", "duration": 0.3}], "word": "ma"},
          {"alignedWord": "oh", "case": "success", "start": 1.5, "end": 2, "phones": [{"phone": "ow_S", "duration": 0.5}],
          "word": "oh"}]})",
      R"({"result": [{"conf": 1, "start": 0.5, "end": 0.9, "word": "ma"}, {"start": 1.5, "end": 2, "word": "oh"}]})",
      R"({"transcription": [{"offsets": {"from": 500, "to": 900}, "text": " ma"},
                            {"offsets": {"from": 1500, "to": 2000}, "text": " oh"}]})",
      R"({"results": {"items": [{"start_time": "0.5", "end_time": "0.9", "alternatives": [{"content": "ma"}]},
                                {"start_time": "1.5", "end_time": "2.0", "alternatives": [{"content": "oh"}]}]}})",
      R"({"alignment": {"characters": ["m", "a", " ", "o", "h"], "character_start_times_seconds": [0.5, 0.6, 0.9, 1.5, 1.6],
          "character_end_times_seconds": [0.6, 0.9, 1.5, 1.6, 2]}})",
      R"({"tiers": {"words": {"entries": [[0.5, 0.9, "ma"], [1.5, 2, "oh"]]},
                    "phones": {"entries": [[0.5, 0.6, "M"], [0.6, 0.9, "AA1"], [1.5, 2, "OW1"]]}}})"};
  for (const std::string& text : files) {
    const CueFile cues = cues_of(text);
    EXPECT_EQ(shapes_at(cues, {0.55, 0.8, 1.2, 1.7}), "ADXE") << text;
    EXPECT_EQ(words_in(cues), "ma@0.50 oh@1.50 ") << text;
    ASSERT_NE(format_of_track(base::as_bytes(text)), nullptr) << text;
    EXPECT_EQ(format_of_track(base::as_bytes(text))->name, "cues") << text;
  }
  const CueFile hole = cues_of(R"({"words": [{"word": "ma", "start": 0, "end": 0.4}, {"word": "five"},
                                             {"word": "oh", "start": 1, "end": 2}]})");
  EXPECT_EQ(words_in(hole), "ma@0.00 five@0.40 oh@1.00 ");
  EXPECT_EQ(hole.notes.size(), 1U);
}

TEST(CueFile, FarMoreWordsThanHoursOfSpeechAreRefused) {
  std::string text;
  for (int i = 0; i < 8000; ++i)
    text += std::to_string(i) + "\t" + std::to_string(i + 1) + "\tsupercalifragilisticexpialidocious\n";
  const auto read = read_cues(base::as_bytes(text));
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().what.find("150,000"), std::string::npos);
}

TEST(CueFile, WhatIsNoListOfCuesIsToldWhatIsRead) {
  const auto text = read_cues(base::as_bytes(std::string_view("good morning\n"))).error();
  EXPECT_NE(text.remedy.find("TextGrid"), std::string::npos);
  EXPECT_NE(text.remedy.find("WebVTT"), std::string::npos);
  const auto binary = read_cues(base::as_bytes(std::string_view("\x01\x02\0\0abc", 7))).error();
  EXPECT_EQ(binary.what, "the file is neither a sound that is read here nor a list of cues");
  EXPECT_EQ(binary.line().find("again"), std::string::npos) << binary.line();
}

}  // namespace
}  // namespace penpose::io
