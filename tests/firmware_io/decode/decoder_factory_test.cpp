#include "firmware_io/decode/decoder_factory.h"

#include <gtest/gtest.h>

#include "firmware_io/decode/chosen_tablet.h"
#include "tests/support/hands/pen_reports.h"

namespace penpose::decode {
namespace {

using tests::device;

/// The described pen of tests::ink_descriptor() is read.
void expect_ink_pen(PenDecoder& decoder) {
  PenSample sample;
  sample.in_range = true;
  sample.tool = Tool::pen;
  sample.x = 77;
  EXPECT_EQ(decoder.decode(tests::ink_pen(sample)), ReportKind::pen);
  EXPECT_EQ(decoder.sample().x, 77);
}

TEST(DecoderFactory, APenThatDescribesItselfNeedsNoTable) {
  const auto made = make_decoder(device(0x1b96, 0x1234, tests::ink_descriptor()));
  ASSERT_TRUE(made);
  EXPECT_EQ(made->method, "descriptor");
  expect_ink_pen(*made->decoder);
}

TEST(DecoderFactory, WacomModelsGoByTheirProductId) {
  const auto made = make_decoder(device(0x056a, 0x00b9));
  ASSERT_TRUE(made);
  EXPECT_EQ(made->method, "wacom Intuos4 6x9");
}

TEST(DecoderFactory, DescribedRangesOfAWacomModelKeepItsSize) {
  // ISDv4 90 has 262.02 by 163.25 mm at 100 units; the descriptor tells 0 to 21240 by 0 to 15980.
  DeviceIdentity device;
  device.vendor = 0x056a;
  device.product = 0x0090;
  device.report_descriptor = {0x05, 0x0d, 0x09, 0x02, 0xa1, 0x01, 0x85, 0x02, 0x09, 0x20, 0xa1, 0x00, 0x09,
                              0x42, 0x09, 0x32, 0x15, 0x00, 0x25, 0x01, 0x75, 0x01, 0x95, 0x02, 0x81, 0x02,
                              0x95, 0x06, 0x81, 0x03, 0x05, 0x01, 0x75, 0x10, 0x95, 0x01, 0x09, 0x30, 0x26,
                              0xf8, 0x52, 0x81, 0x02, 0x09, 0x31, 0x26, 0x6c, 0x3e, 0x81, 0x02, 0xc0, 0xc0};
  const auto made = make_decoder(device);
  ASSERT_TRUE(made.ok());
  const PenAxes& axes = made->decoder->axes();
  EXPECT_EQ(axes.x.maximum, 21240);
  EXPECT_EQ(axes.x.units_per_mm, 81);
  EXPECT_EQ(axes.y.maximum, 15980);
  EXPECT_EQ(axes.y.units_per_mm, 98);
}

TEST(DecoderFactory, EveryModelOfTheTableIsMadeOrIsForTouchOnly) {
  for (const std::uint16_t bus : {k_bus_usb, k_bus_bluetooth}) {
    for (std::uint32_t product = 0; product < 0x10000; ++product) {
      DeviceIdentity identity = device(0x056a, static_cast<std::uint16_t>(product));
      identity.bus = bus;
      const auto made = make_decoder(identity);
      if (!made) continue;
      EXPECT_NE(made->decoder, nullptr) << product;
    }
  }
}

TEST(DecoderFactory, TheTouchInterfaceOfAPenTabletIsNoPen) {
  // Vendor-defined reports of 64 bytes, as on Intuos5 and Intuos Pro.
  const tests::Report opaque{0x06, 0x00, 0xff, 0x09, 0x80, 0xa1, 0x01, 0x85, 0x02, 0x09, 0x01, 0x15,
                             0x00, 0x26, 0xff, 0x00, 0x75, 0x08, 0x95, 0x3f, 0x81, 0x02, 0xc0};
  EXPECT_FALSE(make_decoder(device(0x056a, 0x0026, opaque)));
  EXPECT_TRUE(make_decoder(device(0x056a, 0x00b9, opaque)));
}

TEST(DecoderFactory, UnknownWacomModelsAreReadByTheirDescriptor) {
  const auto made = make_decoder(device(0x056a, 0x0391, tests::ink_descriptor()));
  ASSERT_TRUE(made);
  EXPECT_EQ(made->method, "descriptor");
}

TEST(DecoderFactory, AMouseIsRefusedWithWhatToDo) {
  const tests::Report mouse{0x05, 0x01, 0x09, 0x02, 0xa1, 0x01, 0x09, 0x30, 0x09, 0x31, 0x15,
                            0x81, 0x25, 0x7f, 0x75, 0x08, 0x95, 0x02, 0x81, 0x06, 0xc0};
  const auto made = make_decoder(device(0x0458, 0x0138, mouse));
  ASSERT_FALSE(made);
  EXPECT_FALSE(made.error().remedy.empty());
}

TEST(DecoderFactory, AnIllegalDescriptorIsNamedInTheError) {
  const auto made = make_decoder(device(0x1b96, 0x1234, {0x05, 0x0d, 0xc0}));
  ASSERT_FALSE(made);
  EXPECT_NE(made.error().what.find("byte 2"), std::string::npos);
}

TEST(DecoderFactory, ATabletOfTheTableIsReadInBothItsModes) {
  // A described pen on report 7; the vendor's own reports come once the tablet was switched to them.
  DeviceIdentity identity = device(0x28bd, 0x0914, tests::ink_descriptor());
  identity.input_report_length = 14;
  identity.output_report_length = 14;
  const auto made = make_decoder(identity);
  ASSERT_TRUE(made);
  EXPECT_EQ(made->method, "descriptor, protocol xp_pen");
  EXPECT_EQ(made->decoder->decode(tests::Report{0x02, 0xa1, 0x10, 0x27, 0x20, 0x4e, 0xe8, 0x03, 0, 0, 0, 0}),
            ReportKind::pen);
  EXPECT_EQ(made->decoder->sample().x, 10000);
  EXPECT_EQ(made->decoder->sample().pressure, 1000);
  expect_ink_pen(*made->decoder);
}

TEST(DecoderFactory, ATabletThatWasNamedIsReadByItsIdsWhereTheRecordingHasNone) {
  const auto named = [](const char* name, const DeviceIdentity& recorded) {
    const auto chosen = known_tablets().choose(name);
    EXPECT_TRUE(chosen.ok()) << chosen.error().line();
    EXPECT_EQ(make_decoder(identified(recorded, &*chosen), &*chosen)->method, make_decoder(recorded, &*chosen)->method);
    return make_decoder(recorded, &*chosen);
  };
  DeviceIdentity nameless;
  nameless.bus = 0;
  EXPECT_EQ(named("PTH-451", nameless)->method, "wacom Intuos Pro S");
  EXPECT_EQ(named("Cintiq 22HD (DTK-2200)", nameless)->method, "wacom Cintiq 22HD");
  const auto huion = named("H640P", nameless);
  EXPECT_EQ(huion->method, "protocol uclogic_tilt");
  EXPECT_EQ(huion->decoder->axes().x.maximum, 32000);
  EXPECT_EQ(huion->guess, "");
  // Ids that it has count.
  EXPECT_EQ(named("H640P", device(0x056a, 0x0314))->method, "wacom Intuos Pro S");
}

/// Gaomon's M5 V2, which no string needs to tell.
TEST(DecoderFactory, ATabletWithAnIdOfItsOwnNeedsNoStrings) {
  const auto made = make_decoder(device(0x256c, 0x200e));
  ASSERT_TRUE(made);
  EXPECT_EQ(made->guess, "");
  EXPECT_EQ(made->decoder->axes().x.maximum, 35560);
  EXPECT_NEAR(made->decoder->axes().x.units_per_mm, 200, 0.1);
  const tests::Report report{8, 0x81, 0x10, 0x27, 0x20, 0x4e, 0xff, 0x3f, 0, 0, 0, 0};
  ASSERT_EQ(made->decoder->decode(report), ReportKind::pen);
  EXPECT_EQ(made->decoder->sample().x, 10000);
  EXPECT_EQ(made->decoder->sample().y, 20000);
  EXPECT_EQ(made->decoder->sample().pressure, 16383);
}

TEST(CompleteIdentity, TakesLengthsFromTheDescriptor) {
  DeviceIdentity identity = device(1, 2, tests::ink_descriptor());
  identity.output_report_length = 9;
  complete_identity(identity);
  EXPECT_EQ(identity.input_report_length, 12);
  EXPECT_EQ(identity.output_report_length, 9);
  EXPECT_EQ(identity.feature_report_length, 0);
}

}  // namespace
}  // namespace penpose::decode
