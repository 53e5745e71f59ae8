#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace penpose::tests {

/// A trace in hid-recorder's text form, written without the code that the tests are about.
class TraceText {
 public:
  explicit TraceText(std::string line_end = "\n") : end_(std::move(line_end)) {}

  TraceText& line(const std::string& text) {
    text_ += text + end_;
    return *this;
  }
  TraceText& device(int number, const std::vector<std::uint8_t>& descriptor, const std::string& ids) {
    line("D: " + std::to_string(number));
    line("R: " + counted(descriptor));
    line("N: Test pen " + std::to_string(number));
    line("P: usb-test/input" + std::to_string(number));
    return line("I: " + ids);
  }
  TraceText& report(std::int64_t time_us, const std::vector<std::uint8_t>& report) {
    std::string micros = std::to_string(time_us % 1000000);
    micros.insert(0, 6 - micros.size(), '0');
    return line("E: " + std::to_string(time_us / 1000000) + "." + micros + " " + counted(report));
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  static std::string counted(const std::vector<std::uint8_t>& bytes) {
    const char* const digits = "0123456789abcdef";
    std::string text = std::to_string(bytes.size());
    for (const std::uint8_t byte : bytes) {
      text += ' ';
      text += digits[byte / 16];
      text += digits[byte % 16];
    }
    return text;
  }

  std::string end_;
  std::string text_;
};

}  // namespace penpose::tests
