#include "ui/cli/tablet/hand_decode.h"

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/decode_run.h"
#include "tests/support/hands/hand_descriptors.h"
#include "tests/support/hands/trace_text.h"
#include "tests/support/shared_data.h"

namespace penpose::cli {
namespace {

using tests::Outcome;

class HandDecode : public tests::DecodeRun {};
class SharedHandDecode : public tests::DecodeRun {};

/// An Intuos Pro whose second key is pressed while the ring is touched, and let go.
std::string pad_trace() {
  tests::TraceText trace;
  trace.device(0, tests::ink_descriptor(), "3 056a 0314");
  trace.report(0, {0x02, 0xe0, 1, 2, 3, 4, 5, 6, 7, 8});
  trace.report(5000, {0x03, 0, 0x8a, 0, 1, 0, 0, 0, 0, 0});
  trace.report(10000, {0x03, 0, 0x8a, 0, 1, 0, 0, 0, 0, 0});
  trace.report(15000, {0x03, 0, 0x00, 0, 0, 0, 0, 0, 0, 0});
  return trace.text();
}

std::string touch_trace() {
  tests::TraceText trace;
  trace.device(0, tests::touch_descriptor(2), "3 1b96 1000");
  trace.report(0, tests::touch_report({{5, 1, 900, 5}, {5, 2, 20, 7}}, 2));
  trace.report(5000, tests::touch_report({{0, 1, 0, 0}, {0, 2, 0, 0}}, 2));
  return trace.text();
}

TEST_F(HandDecode, WhereOnlyFingersCameThePensReaderSaysWhatPrintsThem) {
  const Outcome outcome = decode(touch_trace());
  EXPECT_NE(
      outcome.error.find("2 reports, none of a pen: this interface carries fingers and no pen; --touch prints them"),
      std::string::npos)
      << outcome.error;
}

TEST_F(HandDecode, RowsOfAPadAreItsChanges) {
  EXPECT_EQ(decoded(pad_trace(), {"--pad", "--csv"}),
            "report,time_us,keys,ring,ring2,strip,strip2,wheel,hwheel\n"
            "1,5000,BTN_1,10,,,,0,0\n"
            "3,15000,-,0,,,,0,0\n");
}

TEST_F(HandDecode, RowsOfTouchAreItsFrames) {
  EXPECT_EQ(decoded(touch_trace(), {"--touch", "--csv"}),
            "report,time_us,contacts\n"
            "0,0,20:7 900:5\n"
            "1,5000,-\n");
}

TEST_F(HandDecode, JsonTellsWhatThereIs) {
  const auto pad = nlohmann::json::parse(decode(pad_trace(), {"--pad", "--json"}).out);
  ASSERT_EQ(pad["pad"].size(), 2u);
  EXPECT_EQ(pad["pad"][0]["keys"], nlohmann::json({"BTN_1"}));
  EXPECT_EQ(pad["pad"][0]["rings"], nlohmann::json({10}));
  EXPECT_EQ(pad["devices"][0]["pad"]["keys"].size(), 7u);
  EXPECT_EQ(pad["devices"][0]["pad"]["ring_maximum"], 71);
  const auto touch = nlohmann::json::parse(decode(touch_trace(), {"--touch", "--json"}).out);
  EXPECT_EQ(touch["touch"][0]["contacts"][1]["x"], 900);
  EXPECT_TRUE(touch["touch"][1]["contacts"].empty());
  EXPECT_EQ(touch["devices"][0]["touch"]["x"], nlohmann::json({0, 9600, 0.0}));
}

TEST_F(HandDecode, KeysThatAreReadByAGuessSaySo) {
  const std::string trace = tests::TraceText()
                                .device(0, {}, "3 256c 006e")
                                .report(0, {0x08, 0xe0, 0x01, 0x01, 0x01, 0, 0, 0, 0, 0, 0, 0})
                                .text();
  const Outcome guessed = decode(trace, {"--pad"});
  EXPECT_NE(guessed.out.find("BTN_"), std::string::npos) << guessed.out;
  EXPECT_NE(guessed.error.find(": a guess: one of "), std::string::npos) << guessed.error;
  const auto json = nlohmann::json::parse(decode(trace, {"--pad", "--json"}).out, nullptr, false);
  EXPECT_NE(json["devices"][0]["guess"].get<std::string>().find("256c:006e"), std::string::npos);
  const Outcome named = decode(trace, {"--pad", "--tablet", "New 1060 Plus"});
  EXPECT_EQ(named.out, guessed.out);
  EXPECT_EQ(named.error, "");
}

TEST_F(HandDecode, WithoutAHandThereAreNoRows) {
  const auto outcome = decode(touch_trace(), {"--pad", "--csv"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out, "report,time_us,keys,ring,ring2,strip,strip2,wheel,hwheel\n");
}

TEST_F(HandDecode, OfSeveralInterfacesTheRowsSayWhich) {
  tests::TraceText trace;
  trace.device(0, tests::ink_descriptor(), "3 056a 0314");
  trace.device(1, tests::touch_descriptor(2), "3 1b96 1000");
  trace.line("D: 1").report(0, tests::touch_report({{5, 1, 1, 2}, {0, 2, 0, 0}}, 2));
  EXPECT_EQ(decode(trace.text(), {"--touch", "--csv"}).out, "report,time_us,contacts,device\n0,0,1:2,1\n");
}

TEST_F(HandDecode, TheSlideOfOneTabletLeavesTheFingersOfAnotherAsTheyAre) {
  const auto finger = tests::touch_report({{5, 1, 10, 20}, {0, 0, 0, 0}}, 1);
  tests::TraceText trace;
  int device = 0;
  for (const char* unit : {"usb-1", "usb-2"}) {
    for (const auto& [part, descriptor] :
         {std::pair{"/input0", tests::wacom_pad_descriptor()}, std::pair{"/input1", tests::touch_descriptor(2)}}) {
      trace.device(device++, descriptor, "3 056a fff0");
      trace.line(std::string("P: ") + unit + part);
    }
  }
  // The first one's slide turns its fingers on; of the second one's nothing is known yet.
  trace.line("D: 0").report(0, {0x11, 0, 0x02, 0, 0});
  trace.line("D: 1").report(5000, finger);
  trace.line("D: 3").report(10000, finger);
  trace.line("D: 2").report(15000, {0x11, 0, 0x02, 0, 0});
  trace.line("D: 3").report(20000, finger);
  EXPECT_EQ(decode(trace.text(), {"--touch", "--csv"}).out,
            "report,time_us,contacts,device\n1,5000,10:20,1\n4,20000,10:20,3\n");
}

TEST_F(HandDecode, AnyReportsCanBeReadWithAProtocol) {
  tests::TraceText trace;
  trace.device(0, {0x05, 0x0d, 0xc0}, "3 0000 0000");
  trace.report(0, {8, 0xe0, 1, 1, 0x05, 0, 0});
  const auto outcome = decode(trace.text(), {"--pad", "--protocol", "huion_ring"});
  EXPECT_NE(outcome.out.find("0,0,BTN_0+BTN_2,0,,,,0,0\n"), std::string::npos) << outcome.out << outcome.error;
}

/// Tablets whose descriptors hid-uclogic and an HID-BPF program have put in place of their own.
TEST_F(SharedHandDecode, KeysThatLinuxDescribesAreRead) {
  const auto folder = tests::shared_dir() / "cases" / "pens" / "pad-described-by-linux";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no shared cases";
  const auto rows = [&](const char* file) {
    const Outcome outcome = run_program({"decode", (folder / file).string(), "--pad"});
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_EQ(outcome.error, "");
    return outcome.out.substr(outcome.out.find('\n') + 1);
  };
  EXPECT_EQ(rows("huion_h640p_uclogic.hid"),
            "0,0,BTN_0,,,,,0,0\n"
            "1,8000,-,,,,,0,0\n"
            "2,16000,BTN_1,,,,,0,0\n"
            "3,24000,-,,,,,0,0\n");
  EXPECT_EQ(rows("deco01v3_hid_bpf.hid"),
            "0,0,BTN_0,,,,,0,0\n"
            "1,8000,BTN_0+BTN_1,,,,,0,0\n"
            "2,16000,BTN_7,,,,,0,0\n"
            "3,24000,-,,,,,0,0\n");
}

TEST_F(HandDecode, WrongUsageAndWrongFilesAreSaid) {
  EXPECT_EQ(decode(pad_trace(), {"--pad", "--touch"}).status, 2);
  const auto outcome = decode("nothing of the kind\n", {"--pad"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.error.find("is no recording"), std::string::npos) << outcome.error;
  // Lines that cannot be read add nothing to that.
  const auto broken = decode("R: 2 05\nE: 0.1 9 00\nE: 0.2", {"--touch"});
  EXPECT_EQ(broken.status, 1);
  EXPECT_EQ(std::count(broken.error.begin(), broken.error.end(), '\n'), 1) << broken.error;
}

}  // namespace
}  // namespace penpose::cli
