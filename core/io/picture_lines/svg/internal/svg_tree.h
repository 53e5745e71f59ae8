#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <pugixml.hpp>
#include <string>
#include <string_view>

#include "core/base/byte_reader.h"
#include "core/base/result.h"
#include "core/io/picture_lines/svg/internal/svg_style.h"

namespace penpose::io {

/// The value of one of an element's attributes; empty where it has none.
[[nodiscard]] inline std::string_view text_of(pugi::xml_node node, const char* name) {
  const pugi::xml_attribute attribute = node.attribute(name);
  return attribute.value();
}

/// The elements of an SVG, found by their `id`, and its style sheets.
class SvgTree {
 public:
  /// Errors: no XML, no SVG, or more of anything than a drawing has.
  static base::Result<SvgTree> parse(base::Bytes bytes);

  [[nodiscard]] pugi::xml_node root() const { return root_; }
  /// The name of an element of SVG; empty for those of other vocabularies.
  [[nodiscard]] std::string_view tag(pugi::xml_node node) const;
  /// The element that `href` or `xlink:href` of another one names; none where it is not in this file.
  [[nodiscard]] pugi::xml_node target(pugi::xml_node node) const;
  [[nodiscard]] const SvgStyleSheet& style_sheet() const { return style_sheet_; }
  /// An error with the line that an element begins in, and its name.
  [[nodiscard]] base::Error error(pugi::xml_node node, const std::string& what, std::string remedy) const;

 private:
  explicit SvgTree(std::string_view text) : text_(text) {}
  base::Status collect();
  [[nodiscard]] std::string line_of(std::size_t offset) const;

  std::string_view text_;
  std::unique_ptr<pugi::xml_document> document_ = std::make_unique<pugi::xml_document>();
  pugi::xml_node root_;
  std::string prefix_;  ///< of SVG's own elements, with its colon
  std::map<std::string_view, pugi::xml_node> by_id_;
  SvgStyleSheet style_sheet_;
};

}  // namespace penpose::io
