#include "core/io/picture_lines/svg/internal/svg_style.h"

#include <algorithm>
#include <utility>

#include "core/io/picture_lines/svg/internal/words.h"

namespace penpose::io {
namespace {

constexpr std::size_t k_most_rules = 512;

std::string without_comments(std::string_view css) {
  std::string text;
  while (true) {
    const std::size_t begin = css.find("/*");
    text += css.substr(0, begin);
    const std::size_t end = begin == std::string_view::npos ? begin : css.find("*/", begin + 2);
    if (end == std::string_view::npos) return text;
    css.remove_prefix(end + 2);
  }
}

bool is_painted(std::string_view value) { return value != "none" && value != "transparent"; }

/// How long the block is that a text begins with, up to its last brace.
std::size_t length_of_block(std::string_view css) {
  std::size_t depth = 0;
  for (std::size_t i = 0; i < css.size(); ++i) {
    if (css[i] == '{') ++depth;
    if (css[i] == '}' && --depth == 0) return i + 1;
  }
  return css.size();
}

bool has_word(std::string_view words, std::string_view wanted) {
  while (!words.empty()) {
    if (take_svg_word(words) == wanted) return true;
  }
  return false;
}

}  // namespace

void SvgProperties::set(std::string_view property, std::string_view value) {
  value = svg_trimmed(value.substr(0, value.find('!')));
  if (value.empty() || value == "inherit") return;
  if (property == "fill") filled = is_painted(value);
  if (property == "stroke") stroked = is_painted(value);
  if (property == "fill-rule") even_odd = value == "evenodd";
  if (property == "visibility") visible = value == "visible";
  if (property == "display") displayed = value != "none";
}

void SvgProperties::set_all(std::string_view declarations) {
  while (!declarations.empty()) {
    const std::size_t end = declarations.find(';');
    const std::string_view one = declarations.substr(0, end);
    const std::size_t colon = one.find(':');
    if (colon != std::string_view::npos) set(svg_trimmed(one.substr(0, colon)), one.substr(colon + 1));
    declarations.remove_prefix(end == std::string_view::npos ? declarations.size() : end + 1);
  }
}

void SvgStyle::take(const SvgProperties& properties) {
  filled = properties.filled.value_or(filled);
  stroked = properties.stroked.value_or(stroked);
  even_odd = properties.even_odd.value_or(even_odd);
  visible = properties.visible.value_or(visible);
  displayed = properties.displayed.value_or(displayed);
}

bool SvgStyleSheet::add(std::string_view css) {
  const std::string text = without_comments(css);
  std::string_view left = svg_trimmed(text);
  while (!left.empty()) {
    const bool is_rule = !left.starts_with('@');
    const std::size_t open = left.find_first_of(is_rule ? "{" : "{;");
    if (open == std::string_view::npos) return true;
    const std::size_t length = left[open] == '{' ? length_of_block(left.substr(open)) : 1;
    if (is_rule && !add_rule(left.substr(0, open), left.substr(open + 1, length - 1))) return false;
    left = svg_trimmed(left.substr(open + length));
  }
  return true;
}

bool SvgStyleSheet::add_rule(std::string_view selectors, std::string_view block) {
  SvgProperties properties;
  properties.set_all(block.substr(0, block.find('}')));
  if (properties == SvgProperties()) return true;
  while (!selectors.empty()) {
    if (rules_.size() == k_most_rules) return false;
    const std::size_t comma = selectors.find(',');
    add_selector(svg_trimmed(selectors.substr(0, comma)), properties);
    selectors.remove_prefix(comma == std::string_view::npos ? selectors.size() : comma + 1);
  }
  return true;
}

void SvgStyleSheet::add_selector(std::string_view selector, const SvgProperties& properties) {
  if (selector.empty() || selector.find_first_of(" \t\r\n\f>+~[]:()\"'") != std::string_view::npos) return;
  Rule rule;
  const std::size_t name = selector.find_first_of(".#");
  rule.tag = selector.substr(0, name);
  if (rule.tag == "*") rule.tag.clear();
  if (name != std::string_view::npos) {
    const std::string_view rest = selector.substr(name + 1);
    if (rest.find_first_of(".#") != std::string_view::npos) return;
    (selector[name] == '.' ? rule.class_name : rule.id) = rest;
  }
  rule.properties = properties;
  const auto behind = std::upper_bound(rules_.begin(), rules_.end(), rule,
                                       [](const Rule& a, const Rule& b) { return a.special() < b.special(); });
  rules_.insert(behind, std::move(rule));
}

void SvgStyleSheet::apply(std::string_view tag, std::string_view id, std::string_view classes, SvgStyle& style) const {
  for (const Rule& rule : rules_) {
    if (!rule.tag.empty() && rule.tag != tag) continue;
    if (!rule.id.empty() && rule.id != id) continue;
    if (!rule.class_name.empty() && !has_word(classes, rule.class_name)) continue;
    style.take(rule.properties);
  }
}

}  // namespace penpose::io
