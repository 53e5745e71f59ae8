#include "firmware_io/decode/wacom/wacom_tools.h"

#include <gtest/gtest.h>

namespace penpose::decode {
namespace {

TEST(WacomTools, NumbersTellToolsApart) {
  EXPECT_EQ(wacom_tool(0x822), WacomTool::pen);
  EXPECT_EQ(wacom_tool(0x10804), WacomTool::pen);  // art pen
  EXPECT_EQ(wacom_tool(0x82a), WacomTool::eraser);
  EXPECT_EQ(wacom_tool(0x1080c), WacomTool::eraser);
  EXPECT_EQ(wacom_tool(0x902), WacomTool::airbrush);
  EXPECT_EQ(wacom_tool(0x90a), WacomTool::eraser);
  EXPECT_EQ(wacom_tool(0x806), WacomTool::mouse);
  EXPECT_EQ(wacom_tool(0x09c), WacomTool::mouse);  // bit 3 without being an eraser
  EXPECT_EQ(wacom_tool(0x097), WacomTool::lens);
  EXPECT_EQ(wacom_tool(0x12345), WacomTool::pen);
}

TEST(WacomTools, BecomeTheToolsOfSamples) {
  EXPECT_EQ(tool_of(WacomTool::none), Tool::none);
  EXPECT_EQ(tool_of(WacomTool::airbrush), Tool::pen);
  EXPECT_EQ(tool_of(WacomTool::eraser), Tool::eraser);
  EXPECT_EQ(tool_of(WacomTool::lens), Tool::mouse);
  EXPECT_EQ(wacom_tool_id(0x10802), 0x100802u);
  EXPECT_EQ(wacom_tool_id(0x822), 0x822u);
}

}  // namespace
}  // namespace penpose::decode
