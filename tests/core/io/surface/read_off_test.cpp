#include "core/io/surface/read_off.h"

#include <gtest/gtest.h>
#include <string>
#include <utility>

#include "tests/support/error_of.h"

namespace penpose::io {
namespace {

base::Result<document::Model> read(const std::string& text) { return read_off(base::as_bytes(text)); }
base::Error error(const std::string& text) { return tests::error_of(read(text)); }

TEST(ReadOff, QuadsCommentsAndColours) {
  const auto model = read("OFF # a square\n4 1 0\n0 0 0\n1 0 0\n# between\n1 1 0\n0 1 0\n4 0 1 2 3 255 0 0\n");
  ASSERT_TRUE(model.ok()) << model.error().line();
  EXPECT_EQ(model->mesh->vertex_count(), 4U);
  EXPECT_EQ(model->mesh->triangle_count(), 2U);
  EXPECT_EQ(model->notes, std::vector<std::string>{"colours were left out"});
}

TEST(ReadOff, NormalsAndCountsOnTheFirstLine) {
  const auto model = read("NOFF 3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2");
  ASSERT_TRUE(model.ok()) << model.error().line();
  EXPECT_EQ(model->mesh->file_normals()[2], glm::vec3(0, 0, 1));
}

TEST(ReadOff, NamesTheLineOfAFault) {
  const std::pair<const char*, const char*> faults[] = {{"PLY\n", "line 1"},
                                                        {"4OFF\n", "line 1"},
                                                        {"OFF BINARY\n", "line 1"},
                                                        {"OFF\nmany 1 0\n", "line 2"},
                                                        {"OFF\n4000000000 4000000000 0\n0 0 0\n", "line 2"},
                                                        {"OFF\n18446744073709551615 1 0\n", "line 2"},
                                                        {"OFF\n3 1 0\n0 0 0\n1 0 inf\n0 1 0\n3 0 1 2\n", "line 4"},
                                                        {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "line 6"},
                                                        {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n9999 0 1 2\n", "line 6"},
                                                        {"OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "line 6"},
                                                        {"OFF\n3 1 0\n0.00 0.00 0.00\n1.00 0.00 0.00\n", "line 4"}};
  for (const auto& [text, line] : faults) EXPECT_EQ(error(text).place, line) << text;
}

}  // namespace
}  // namespace penpose::io
