#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace penpose::io {

/// Properties that say whether a shape is seen; those that nobody set are empty.
struct SvgProperties {
  std::optional<bool> filled;
  std::optional<bool> stroked;
  std::optional<bool> even_odd;  ///< fill-rule
  std::optional<bool> visible;
  std::optional<bool> displayed;

  /// Takes a property by its CSS name; those that do not matter here are left alone.
  void set(std::string_view property, std::string_view value);
  /// Takes a list of declarations, as in a `style` attribute.
  void set_all(std::string_view declarations);

  friend bool operator==(const SvgProperties&, const SvgProperties&) = default;
};

/// What an element looks like, as far as lines care.
struct SvgStyle {
  bool filled = true;
  bool stroked = false;
  bool even_odd = false;
  bool visible = true;
  bool displayed = true;  ///< of the element and all that it is in

  void take(const SvgProperties& properties);
};

/// Rules of `style` elements whose selector is one element: `tag`, `.class`, `#id`, `tag.class`, `tag#id` or `*`. Those
/// that ask for what is around an element are left out.
class SvgStyleSheet {
 public:
  /// Adds the rules of a text; false where more than 512 in all say something that
  /// matters here.
  bool add(std::string_view css);
  /// How many rules there are.
  [[nodiscard]] std::size_t size() const { return rules_.size(); }
  /// Sets what the rules say of an element, the more special ones last. `classes`: its `class` attribute.
  void apply(std::string_view tag, std::string_view id, std::string_view classes, SvgStyle& style) const;

 private:
  struct Rule {
    std::string tag;  ///< each is empty where the rule does not ask for it
    std::string class_name;
    std::string id;
    SvgProperties properties;

    [[nodiscard]] int special() const { return (id.empty() ? 0 : 4) + (class_name.empty() ? 0 : 2) + !tag.empty(); }
  };
  bool add_rule(std::string_view selectors, std::string_view block);
  void add_selector(std::string_view selector, const SvgProperties& properties);

  std::vector<Rule> rules_;  ///< the more special ones last
};

}  // namespace penpose::io
