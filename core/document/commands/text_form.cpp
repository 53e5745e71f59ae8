#include "core/document/commands/text_form.h"

#include <algorithm>
#include <array>

#include "core/base/members.h"
#include "core/base/numbers.h"
#include "core/base/text/letters.h"
#include "core/geometry/lasso.h"

namespace penpose::document {
namespace {

bool stands_for_itself(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' || c == '.';
}

using articulation::CurveRole;
using articulation::Mode;
using articulation::Reach;
template <typename Enum, std::size_t N>
using Names = std::array<std::pair<Enum, std::string_view>, N>;
constexpr Names<Mode, 3> k_modes{{{Mode::automatic, "auto"}, {Mode::translate, "translate"}, {Mode::rotate, "rotate"}}};
constexpr Names<Reach, 2> k_reaches{{{Reach::through, "through"}, {Reach::front, "front"}}};
constexpr Names<CurveRole, 4> k_roles{{{CurveRole::general, "general"},
                                       {CurveRole::specific, "specific"},
                                       {CurveRole::reference, "reference"},
                                       {CurveRole::target, "target"}}};
constexpr Names<KeyKind, 9> k_key_kinds{{{KeyKind::smooth, "smooth"},
                                         {KeyKind::linear, "linear"},
                                         {KeyKind::stepped, "stepped"},
                                         {KeyKind::ease_in, "ease_in"},
                                         {KeyKind::ease_out, "ease_out"},
                                         {KeyKind::ease, "ease"},
                                         {KeyKind::free, "free"},
                                         {KeyKind::overshoot, "overshoot"},
                                         {KeyKind::none, "none"}}};
constexpr Names<Preset, 3> k_presets{{{Preset::meant, "meant"}, {Preset::exact, "exact"}, {Preset::paper, "paper"}}};

template <std::size_t N>
void write_numbers(std::string& out, const std::array<double, N>& values) {
  for (std::size_t i = 0; i < N; ++i) {
    if (i > 0) out += ',';
    TextForm<double>::write(out, values[i]);
  }
}
template <std::size_t N>
std::optional<std::array<double, N>> read_numbers(std::string_view text) {
  std::array<double, N> values{};
  for (std::size_t i = 0; i < N; ++i) {
    const bool last = i + 1 == N;
    if (!last && text.find(',') == std::string_view::npos) return std::nullopt;
    const auto value = TextForm<double>::read(last ? text : take_piece(text, ','));
    if (!value) return std::nullopt;
    values[i] = *value;
  }
  return values;
}

std::optional<geometry::ModelPoint> read_point(std::string_view text) {
  const auto values = read_numbers<3>(text);
  if (!values) return std::nullopt;
  return geometry::ModelPoint((*values)[0], (*values)[1], (*values)[2]);
}

/// How many pieces between commas a member takes.
template <typename Value>
constexpr std::size_t k_pieces = std::is_same_v<Value, geometry::ModelPoint> ? 3 : 1;

/// The members of a surface with commas between them; what is left belongs to the last.
template <typename Kind>
std::optional<articulation::Surface> read_members(std::string_view text) {
  Kind kind;
  bool whole = true;
  std::size_t left = decltype(Kind::members(kind))::k_count;
  base::each_member(kind, [&]<typename Value>(std::string_view, Value& member) {
    std::size_t end = text.size();
    if (--left > 0) {
      end = text.find(',');
      for (std::size_t i = 1; i < k_pieces<Value> && end != std::string_view::npos; ++i) end = text.find(',', end + 1);
    }
    auto value = TextForm<Value>::read(text.substr(0, end));
    whole = whole && value && end != std::string_view::npos;
    if (!whole) return;
    member = *std::move(value);
    text.remove_prefix(std::min(end + 1, text.size()));
  });
  return whole ? std::optional<articulation::Surface>(std::move(kind)) : std::nullopt;
}

std::optional<int> read_side(std::string_view text) {
  const auto value = base::parse_int(text);
  if (!value || *value < 1 || *value > k_largest_side_px) return std::nullopt;
  return static_cast<int>(*value);
}

}  // namespace

std::string escape(std::string_view text) {
  if (text.empty()) return "%";
  std::string out;
  for (const char c : text) {
    if (stands_for_itself(c)) {
      out += c;
      continue;
    }
    out += '%';
    base::append_hex(out, static_cast<unsigned char>(c), 2, base::HexCase::upper);
  }
  return out;
}

std::optional<std::string> unescape(std::string_view text) {
  if (text == "%") return std::string();
  if (text.empty()) return std::nullopt;
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (stands_for_itself(text[i])) {
      out += text[i];
      continue;
    }
    if (text[i] != '%' || i + 2 >= text.size()) return std::nullopt;
    const auto high = base::hex_value(text[i + 1]);
    const auto low = base::hex_value(text[i + 2]);
    if (!high || !low) return std::nullopt;
    out += static_cast<char>(static_cast<unsigned char>(*high * 16U + *low));
    i += 2;
  }
  return out;
}

std::string_view take_piece(std::string_view& text, char separator) {
  const std::size_t end = text.find(separator);
  const std::string_view piece = text.substr(0, end);
  text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
  return piece;
}

void TextForm<double>::write(std::string& out, double value) { out += base::format_double(value); }
std::optional<double> TextForm<double>::read(std::string_view text) {
  const auto value = base::parse_double(text);
  if (!value || !(std::abs(*value) <= k_largest_number)) return std::nullopt;
  return value;
}

std::optional<bool> TextForm<bool>::read(std::string_view text) {
  if (text == "1") return true;
  if (text == "0") return false;
  return std::nullopt;
}

std::optional<std::uint32_t> TextForm<std::uint32_t>::read(std::string_view text) {
  const auto value = base::parse_uint(text);
  if (!value || *value > 0xffffffffU) return std::nullopt;
  return static_cast<std::uint32_t>(*value);
}

std::optional<CurveId> TextForm<CurveId>::read(std::string_view text) {
  const auto value = TextForm<std::uint32_t>::read(text);
  if (!value) return std::nullopt;
  return CurveId{*value};
}

void TextForm<PxPoint>::write(std::string& out, const PxPoint& value) { write_numbers<2>(out, {value.x, value.y}); }
std::optional<PxPoint> TextForm<PxPoint>::read(std::string_view text) {
  const auto values = read_numbers<2>(text);
  if (!values || std::abs((*values)[0]) > geometry::k_largest_px || std::abs((*values)[1]) > geometry::k_largest_px) {
    return std::nullopt;
  }
  return PxPoint{(*values)[0], (*values)[1]};
}

void TextForm<geometry::ModelPoint>::write(std::string& out, const geometry::ModelPoint& value) {
  write_numbers<3>(out, {value.x, value.y, value.z});
}
std::optional<geometry::ModelPoint> TextForm<geometry::ModelPoint>::read(std::string_view text) {
  return read_point(text);
}

void TextForm<mesh::MeshPoint>::write(std::string& out, const mesh::MeshPoint& value) {
  TextForm<std::uint32_t>::write(out, value.triangle);
  out += ',';
  write_numbers<3>(out, value.barycentric);
}
std::optional<mesh::MeshPoint> TextForm<mesh::MeshPoint>::read(std::string_view text) {
  if (text.find(',') == std::string_view::npos) return std::nullopt;
  const auto triangle = TextForm<std::uint32_t>::read(take_piece(text, ','));
  const auto corners = read_numbers<3>(text);
  if (!triangle || !corners) return std::nullopt;
  return mesh::MeshPoint{*triangle, *corners};
}

void TextForm<NamedValue>::write(std::string& out, const NamedValue& value) {
  out += escape(value.name);
  out += ',';
  TextForm<double>::write(out, value.value);
}
std::optional<NamedValue> TextForm<NamedValue>::read(std::string_view text) {
  if (text.find(',') == std::string_view::npos) return std::nullopt;
  auto name = unescape(take_piece(text, ','));
  const auto value = TextForm<double>::read(text);
  if (!name || !value) return std::nullopt;
  return NamedValue{*std::move(name), *value};
}

void TextForm<View>::write(std::string& out, const View& value) {
  for (const auto& v : {value.camera.eye, value.camera.look_at, value.camera.up}) {
    write_numbers<3>(out, {v.x, v.y, v.z});
    out += '/';
  }
  TextForm<double>::write(out, value.camera.vertical_fov_degrees);
  out += '/' + std::to_string(value.viewport.width) + 'x' + std::to_string(value.viewport.height);
}
std::optional<View> TextForm<View>::read(std::string_view text) {
  const auto eye = read_point(take_piece(text, '/'));
  const auto look_at = read_point(take_piece(text, '/'));
  const auto up = read_point(take_piece(text, '/'));
  const auto fov = TextForm<double>::read(take_piece(text, '/'));
  const auto width = read_side(take_piece(text, 'x'));
  const auto height = read_side(text);
  if (!eye || !look_at || !up || !fov || !width || !height) return std::nullopt;
  return View{{*eye, *look_at, *up, *fov}, {*width, *height}};
}

void TextForm<articulation::Surface>::write(std::string& out, const articulation::Surface& value) {
  out += of_surface(value, std::string("none"), [](const auto& one) {
    std::string text(one.k_name);
    char before = ':';
    base::each_member(one, [&]<typename Value>(std::string_view, const Value& member) {
      text += std::exchange(before, ',');
      TextForm<Value>::write(text, member);
    });
    return text;
  });
}
std::optional<articulation::Surface> TextForm<articulation::Surface>::read(std::string_view text) {
  if (text == "none") return articulation::Surface();
  const std::string_view name = take_piece(text, ':');
  std::optional<articulation::Surface> surface;
  articulation::each_surface_kind([&]<typename Kind>() {
    if (Kind::k_name == name) surface = read_members<Kind>(text);
  });
  return surface;
}

ValueNames<Mode> value_names(Mode /*any*/) { return k_modes; }
ValueNames<Reach> value_names(Reach /*any*/) { return k_reaches; }
ValueNames<CurveRole> value_names(CurveRole /*any*/) { return k_roles; }
ValueNames<KeyKind> value_names(KeyKind /*any*/) { return k_key_kinds; }
ValueNames<Preset> value_names(Preset /*any*/) { return k_presets; }

}  // namespace penpose::document
