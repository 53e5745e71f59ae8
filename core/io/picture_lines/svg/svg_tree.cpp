#include "core/io/picture_lines/svg/internal/svg_tree.h"

#include <algorithm>
#include <utility>

#include "core/base/text/shown_text.h"
#include "core/io/remedies.h"

namespace penpose::io {
namespace {

constexpr std::size_t k_most_svg_bytes = std::size_t{1} << 25;
constexpr std::ptrdiff_t k_most_tags = 2'000'000;  ///< tags and attributes, each of which takes memory

/// What comes behind a node in the order of the file; none at the end.
pugi::xml_node following(pugi::xml_node node) {
  if (node.first_child()) return node.first_child();
  while (node && !node.next_sibling()) node = node.parent();
  return node.next_sibling();
}

}  // namespace

base::Result<SvgTree> SvgTree::parse(base::Bytes bytes) {
  SvgTree tree(base::as_text(bytes));
  if (bytes.size() > k_most_svg_bytes) {
    return base::Error{"the drawing has more than 32 MB", "", "save its lines alone, without pictures"};
  }
  if (tree.text_.starts_with("\x1f\x8b")) {
    return base::Error{"the drawing is compressed", "", "unpack it with gunzip, or save it as plain SVG"};
  }
  const auto pieces = std::count_if(bytes.begin(), bytes.end(), [](std::uint8_t c) { return c == '<' || c == '='; });
  if (pieces > k_most_tags) {
    return base::Error{"the drawing has more than two million tags and attributes", "", "save its lines alone"};
  }
  const auto parsed = tree.document_->load_buffer(bytes.data(), bytes.size(), pugi::parse_default, pugi::encoding_utf8);
  tree.root_ = tree.document_->document_element();
  const std::string_view name = tree.root_.name();
  if (!name.ends_with("svg") || (name != "svg" && !name.ends_with(":svg"))) {
    return base::Error{"the file does not begin with an svg element", "", "choose an SVG, saved as UTF-8"};
  }
  if (!parsed) {
    const auto offset = static_cast<std::size_t>(std::max<std::ptrdiff_t>(parsed.offset, 0));
    return base::Error{std::string("the XML is damaged: ") + parsed.description(), tree.line_of(offset),
                       k_export_again};
  }
  tree.prefix_ = name.substr(0, name.size() - 3);
  if (auto status = tree.collect(); !status) return status.error();
  return tree;
}

base::Status SvgTree::collect() {
  for (pugi::xml_node node = root_; node; node = following(node)) {
    if (const pugi::xml_attribute id = node.attribute("id")) by_id_.emplace(id.value(), node);
    if (tag(node) != "style") continue;
    for (const pugi::xml_node text : node.children()) {
      if (!style_sheet_.add(text.value())) {
        return error(node, "there are more than 512 rules of style", "save the drawing as plain SVG");
      }
    }
  }
  return base::Done{};
}

std::string_view SvgTree::tag(pugi::xml_node node) const {
  std::string_view name = node.name();
  if (node.type() != pugi::node_element || !name.starts_with(prefix_)) return {};
  name.remove_prefix(prefix_.size());
  return name.find(':') == std::string_view::npos ? name : std::string_view();
}

pugi::xml_node SvgTree::target(pugi::xml_node node) const {
  const pugi::xml_attribute plain = node.attribute("href");
  const std::string_view name = plain ? plain.value() : text_of(node, "xlink:href");
  if (!name.starts_with('#')) return {};
  const auto found = by_id_.find(name.substr(1));
  return found == by_id_.end() ? pugi::xml_node() : found->second;
}

std::string SvgTree::line_of(std::size_t offset) const {
  const std::string_view before = text_.substr(0, std::min(offset, text_.size()));
  return "line " + std::to_string(std::count(before.begin(), before.end(), '\n') + 1);
}

base::Error SvgTree::error(pugi::xml_node node, const std::string& what, std::string remedy) const {
  const std::string_view id = text_of(node, "id");
  std::string who = "the element " + base::shown_name(node.name(), 40);
  if (!id.empty()) who += " \"" + base::shown_name(id, 40) + '"';
  const auto offset = static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 0));
  return {who + ": " + what, line_of(offset), std::move(remedy)};
}

}  // namespace penpose::io
