#pragma once

#include <string>
#include <vector>

#include "core/base/byte_reader.h"

// Texts of trackers, as the tests of their readers write them.

namespace penpose::tests {

inline base::Bytes bytes(const std::string& text) { return base::as_bytes(text); }

/// A text that others are appended to.
inline std::string s(const char* text) { return text; }

inline std::string text_of(double value) { return std::to_string(value); }

/// A table of 68 points in OpenFace's way. Point i of frame f is (100 + 10 (i % 10) + f, 200 + 10 (i / 10)).
struct Table {
  std::string separator = ", ";
  std::string before = "frame, timestamp, confidence, success";
  std::vector<std::string> rows;

  [[nodiscard]] std::string header() const {
    std::string line = before;
    for (const char* axis : {"x_", "y_"}) {
      for (int i = 0; i < 68; ++i) line += separator + axis + std::to_string(i);
    }
    return line + "\n";
  }
  [[nodiscard]] std::string points(int frame) const {
    std::string line;
    for (int i = 0; i < 68; ++i) line += separator + text_of(100 + 10 * (i % 10) + frame);
    for (int i = 0; i < 68; ++i) line += separator + text_of(200 + 10 * (i / 10));
    return line;
  }
  [[nodiscard]] std::string text() const {
    std::string all = header();
    for (const std::string& row : rows) all += row + "\n";
    return all;
  }
};

inline Table two_frames() {
  Table table;
  table.rows = {s("1, 0.000, 0.98, 1") + table.points(0), s("2, 0.040, 0.88, 1") + table.points(1)};
  return table;
}

inline std::string mediapipe_wide(int points, bool normalised) {
  std::string text = "frame,timestamp";
  for (int i = 0; i < points; ++i) {
    const std::string n = std::to_string(i);
    text += s(",x_") + n + ",y_" + n + ",z_" + n;
  }
  for (int f = 0; f < 2; ++f) {
    text += s("\n") + std::to_string(f) + "," + std::to_string(33 * f);
    for (int i = 0; i < points; ++i) {
      const double scale = normalised ? 0.001 : 1;
      text += s(",") + text_of(scale * i) + "," + text_of(scale * (i + 100)) + "," + text_of(-scale * 7);
    }
  }
  return text + "\n";
}

}  // namespace penpose::tests
