#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/byte_writer.h"

namespace penpose::io {

/// Writes the records of a binary FBX file of version 7.4.
class FbxWriter {
 public:
  FbxWriter();
  /// Values belong to the record that was begun last, and come before records within it.
  FbxWriter& begin(std::string_view name);
  FbxWriter& end();
  FbxWriter& whole(std::int32_t value);
  FbxWriter& id(std::int64_t value);
  FbxWriter& number(double value);
  FbxWriter& text(std::string_view value);
  FbxWriter& bytes(std::string_view value);
  FbxWriter& numbers(std::span<const double> values);
  FbxWriter& floats(std::span<const double> values);
  FbxWriter& wholes(std::span<const std::int32_t> values);
  FbxWriter& ids(std::span<const std::int64_t> values);
  /// A record of one value.
  FbxWriter& entry(std::string_view name, std::int32_t value) { return begin(name).whole(value).end(); }
  FbxWriter& entry(std::string_view name, std::string_view value) { return begin(name).text(value).end(); }
  /// The name of an object as binary files have it.
  static std::string named(std::string_view name, std::string_view kind);

  [[nodiscard]] std::vector<std::uint8_t> take();

 private:
  struct Open {
    std::size_t head = 0, values = 0, count = 0;
    bool holds = false;  ///< records
  };
  FbxWriter& value(char kind);
  void array(char kind, std::size_t count, std::size_t size);
  void close_values();
  void put(std::size_t at, std::size_t value);

  std::vector<std::uint8_t> out_;
  std::vector<Open> open_;
};

}  // namespace penpose::io
