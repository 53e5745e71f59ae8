#pragma once

#include <algorithm>
#include <cstdint>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/io/gltf/read/read_gltf.h"

namespace penpose::tests {

/// A .glb file taken apart by other code than that which is tested.
struct FileParts {
  nlohmann::json json;
  std::vector<std::uint8_t> binary;
};
inline FileParts parts_of(const std::vector<std::uint8_t>& bytes) {
  const auto word = [&](std::size_t at) {
    return bytes[at] | (bytes[at + 1] << 8) | (bytes[at + 2] << 16) | (static_cast<std::size_t>(bytes[at + 3]) << 24);
  };
  const auto at = [&](std::size_t i) { return bytes.begin() + static_cast<std::ptrdiff_t>(i); };
  const std::size_t length = word(12);
  FileParts parts{nlohmann::json::parse(at(20), at(20 + length)), {}};
  if (bytes.size() > 20 + length) parts.binary.assign(at(28 + length), bytes.end());
  return parts;
}

/// That `now` has all of `was`: members and entries are equal, lists and the buffer may go on. `but`: pointers whose
/// values may differ.
inline void expect_kept(const nlohmann::json& was, const nlohmann::json& now,
                        const std::vector<std::string>& but = {}) {
  const nlohmann::json flat = was.flatten();
  for (const auto& [pointer, value] : flat.items()) {
    bool differs = pointer == "/buffers/0/byteLength";
    for (const std::string& one : but) differs = differs || pointer.starts_with(one);
    if (differs) continue;
    const nlohmann::json::json_pointer at(pointer);
    ASSERT_TRUE(now.contains(at)) << pointer << " is gone";
    const nlohmann::json& whole = was[at];
    if (whole.empty() && !whole.is_null()) {
      EXPECT_EQ(now[at].type(), whole.type()) << pointer;
    } else {
      EXPECT_EQ(now[at], value) << pointer;
    }
  }
}
inline void expect_kept(const std::vector<std::uint8_t>& was, const std::vector<std::uint8_t>& now,
                        const std::vector<std::string>& but = {}) {
  const FileParts before = parts_of(was);
  const FileParts after = parts_of(now);
  expect_kept(before.json, after.json, but);
  const std::size_t length = before.json["buffers"][0]["byteLength"];
  ASSERT_GE(after.binary.size(), length);
  EXPECT_TRUE(std::equal(before.binary.begin(), before.binary.begin() + static_cast<std::ptrdiff_t>(length),
                         after.binary.begin()));
}

inline document::Model read_glb(const std::vector<std::uint8_t>& bytes) {
  auto model = io::read_gltf(bytes);
  EXPECT_TRUE(model.ok()) << model.error().line();
  return std::move(model).value();
}

}  // namespace penpose::tests
