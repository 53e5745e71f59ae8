#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/state_hash.h"
#include "core/document/commands/command.h"

namespace penpose::document {

/// The largest number that a session can hold.
inline constexpr double k_largest_number = 1e15;
/// The largest side of a view in a session, px.
inline constexpr int k_largest_side_px = 32768;

// How each type of a command's members is written. `write` appends, `read` takes the whole text or nothing.

[[nodiscard]] std::string escape(std::string_view text);
[[nodiscard]] std::optional<std::string> unescape(std::string_view text);

/// The text up to `separator`, which is taken off with it; all of it where there is none.
[[nodiscard]] std::string_view take_piece(std::string_view& text, char separator);

template <typename T>
struct TextForm;

template <>
struct TextForm<double> {
  static void write(std::string& out, double value);
  static std::optional<double> read(std::string_view text);
};
template <>
struct TextForm<bool> {
  static void write(std::string& out, bool value) { out += value ? '1' : '0'; }
  static std::optional<bool> read(std::string_view text);
};
template <>
struct TextForm<std::uint32_t> {
  static void write(std::string& out, std::uint32_t value) { out += std::to_string(value); }
  static std::optional<std::uint32_t> read(std::string_view text);
};
template <>
struct TextForm<std::string> {
  static void write(std::string& out, const std::string& value) { out += escape(value); }
  static std::optional<std::string> read(std::string_view text) { return unescape(text); }
};
/// 32 hexadecimal digits.
template <>
struct TextForm<base::Hash128> {
  static void write(std::string& out, const base::Hash128& value) { out += value.hex(); }
  static std::optional<base::Hash128> read(std::string_view text) { return base::parse_hash(text); }
};
template <>
struct TextForm<CurveId> {
  static void write(std::string& out, CurveId value) { TextForm<std::uint32_t>::write(out, value.value); }
  static std::optional<CurveId> read(std::string_view text);
};
template <>
struct TextForm<PxPoint> {
  static void write(std::string& out, const PxPoint& value);
  static std::optional<PxPoint> read(std::string_view text);
};
template <>
struct TextForm<geometry::ModelPoint> {
  static void write(std::string& out, const geometry::ModelPoint& value);
  static std::optional<geometry::ModelPoint> read(std::string_view text);
};
/// "TRIANGLE,A,B,C": the barycentric coordinates.
template <>
struct TextForm<mesh::MeshPoint> {
  static void write(std::string& out, const mesh::MeshPoint& value);
  static std::optional<mesh::MeshPoint> read(std::string_view text);
};
template <>
struct TextForm<NamedValue> {
  static void write(std::string& out, const NamedValue& value);
  static std::optional<NamedValue> read(std::string_view text);
};
template <>
struct TextForm<View> {
  static void write(std::string& out, const View& value);
  static std::optional<View> read(std::string_view text);
};
template <>
struct TextForm<articulation::Surface> {
  static void write(std::string& out, const articulation::Surface& value);
  static std::optional<articulation::Surface> read(std::string_view text);
};
/// The values of an enumeration with their names.
template <typename Enum>
using ValueNames = std::span<const std::pair<Enum, std::string_view>>;
[[nodiscard]] ValueNames<articulation::Mode> value_names(articulation::Mode any);
[[nodiscard]] ValueNames<articulation::Reach> value_names(articulation::Reach any);
[[nodiscard]] ValueNames<articulation::CurveRole> value_names(articulation::CurveRole any);
[[nodiscard]] ValueNames<KeyKind> value_names(KeyKind any);
[[nodiscard]] ValueNames<Preset> value_names(Preset any);

template <typename Enum>
requires std::is_enum_v<Enum>
struct TextForm<Enum> {
  static void write(std::string& out, Enum value) {
    for (const auto& [one, name] : value_names(value)) {
      if (one == value) out += name;
    }
  }
  static std::optional<Enum> read(std::string_view text) {
    for (const auto& [one, name] : value_names(Enum{})) {
      if (name == text) return one;
    }
    return std::nullopt;
  }
};

template <typename T>
struct TextForm<std::optional<T>> {
  static void write(std::string& out, const std::optional<T>& value) { TextForm<T>::write(out, *value); }
  static std::optional<std::optional<T>> read(std::string_view text) {
    auto value = TextForm<T>::read(text);
    if (!value) return std::nullopt;
    return std::optional<std::optional<T>>(std::move(value));
  }
};

template <typename T>
struct TextForm<std::vector<T>> {
  static void write(std::string& out, const std::vector<T>& values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (i > 0) out += ';';
      TextForm<T>::write(out, values[i]);
    }
  }
  static std::optional<std::vector<T>> read(std::string_view text) {
    std::vector<T> values;
    if (text.ends_with(';')) return std::nullopt;
    while (!text.empty()) {
      auto value = TextForm<T>::read(take_piece(text, ';'));
      if (!value || values.size() == articulation::k_most_points) return std::nullopt;
      values.push_back(*std::move(value));
    }
    return values;
  }
};

}  // namespace penpose::document
