#include "firmware_io/decode/layout/layout_reader.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <utility>

#include "core/base/numbers.h"

namespace penpose::decode {
namespace {

constexpr std::size_t k_longest_text = 512;
constexpr std::int64_t k_longest_layout_report = 4096;

struct NamedKind {
  std::string_view name;
  Gives gives;
};
constexpr std::array<NamedKind, 8> k_kinds{{{"ignored", Gives::ignored},
                                            {"pen", Gives::pen},
                                            {"mouse", Gives::mouse},
                                            {"tool", Gives::tool},
                                            {"leave", Gives::leave},
                                            {"pad", Gives::pad},
                                            {"touch_pad", Gives::touch_pad},
                                            {"touch", Gives::touch}}};

BitTest read_test(const JsonPlace& place) {
  auto test = BitTest::parse(place.text(k_longest_text));
  if (test) return std::move(test).value();
  place.fail(test.error().what, test.error().remedy);
  return {};
}

/// Reads the fields of one layout and keeps track of how long a report must be for them.
class LayoutReader {
 public:
  LayoutReader(const JsonPlace& place, Layout& layout) : place_(place), layout_(layout) {}

  void number(std::string_view name, std::optional<BitNumber>& field) {
    const auto at = place_.at(name);
    if (at.present()) field = parse_number(at, at.text(k_longest_text));
  }
  void test(std::string_view name, std::optional<BitTest>& field) {
    const auto at = place_.at(name);
    if (!at.present()) return;
    field = read_test(at);
    needs(field->reach());
  }
  /// A number, or the word that says that it is taken from elsewhere.
  bool number_or(std::string_view name, std::string_view word, std::optional<BitNumber>& field) {
    const auto at = place_.at(name);
    if (at.present() && at.is_text() && at.text(k_longest_text) == word) return true;
    number(name, field);
    return false;
  }
  void steps(std::string_view name, std::optional<StepField>& field) {
    const auto at = place_.at(name);
    if (!at.present()) return;
    field.emplace();
    if (at.is_text()) {
      field->steps = parse_number(at, at.text(k_longest_text));
      return;
    }
    at.allow_only({"forward", "backward"});
    LayoutReader inner(at, layout_);
    inner.test("forward", field->forward);
    inner.test("backward", field->backward);
  }
  void rotation() {
    const auto at = place_.at("rotation");
    if (!at.present()) return;
    constexpr std::string_view k_marker = "wacom_marker ";
    auto text = at.text(k_longest_text);
    layout_.rotation_is_marker = text.starts_with(k_marker);
    if (layout_.rotation_is_marker) text.erase(0, k_marker.size());
    layout_.rotation = parse_number(at, text);
  }
  void key_codes();
  void contacts();
  void needs(std::size_t length) { layout_.shortest = std::max(layout_.shortest, length); }

 private:
  BitNumber parse_number(const JsonPlace& at, const std::string& text) {
    auto number = BitNumber::parse(text);
    if (!number) {
      at.fail(number.error().what, number.error().remedy);
      return {};
    }
    needs(number->reach());
    return std::move(number).value();
  }

  const JsonPlace& place_;
  Layout& layout_;
};

void LayoutReader::key_codes() {
  const auto at = place_.at("key_codes");
  if (!at.present()) return;
  at.allow_only({"from", "modifiers", "keys"});
  KeyCodes codes;
  codes.first_byte = static_cast<std::uint16_t>(at.at("from").integer(0, k_longest_layout_report - 1));
  codes.modifier_byte = static_cast<std::uint16_t>(at.at("modifiers").integer(0, k_longest_layout_report - 1));
  for (const auto& item : at.at("keys").items()) {
    auto text = item.text();
    KeyCodes::Key key;
    const auto take = [&](std::string_view word, KeyCodes::Modifiers modifiers) {
      if (!text.ends_with(word)) return;
      key.modifiers = modifiers;
      text.erase(text.size() - word.size());
    };
    take(" plain", KeyCodes::Modifiers::none);
    take(" modified", KeyCodes::Modifiers::some);
    const auto code = base::parse_uint(text, 16);
    if (!code || *code > 0xff)
      item.fail("is no key code", "write two hexadecimal digits, ` plain` or ` modified` after them");
    key.code = static_cast<std::uint8_t>(code.value_or(0));
    codes.keys.push_back(key);
  }
  if (codes.keys.size() > 64) at.fail("lists more than 64 keys", "leave some out");
  needs(codes.first_byte + std::size_t{1});
  needs(codes.modifier_byte + std::size_t{1});
  layout_.key_codes = std::move(codes);
}

void LayoutReader::contacts() {
  const auto at = place_.at("contacts");
  if (!at.present()) {
    if (layout_.gives == Gives::touch) place_.fail("says nothing of its contacts", "say where they are in `contacts`");
    return;
  }
  at.allow_only({"from", "size", "most", "ids", "id", "x", "y", "down"});
  ContactList list;
  list.from = static_cast<std::size_t>(at.at("from").integer(0, k_longest_layout_report - 1));
  list.size = static_cast<std::size_t>(at.at("size").integer(1, k_longest_layout_report));
  list.most = static_cast<std::size_t>(at.at("most").integer(1, 64));
  const auto ids = at.at("ids").items();
  if (ids.size() != 2) {
    at.at("ids").fail("is no pair of numbers", "write the first and the last number that a finger may have");
    return;
  }
  list.first_id = ids[0].integer(0, 65535);
  list.last_id = ids[1].integer(0, 65535);
  if (list.last_id < list.first_id || list.last_id - list.first_id >= 64)
    at.at("ids").fail("are not 1 to 64 numbers", "write the first and the last number that a finger may have");
  // What stands in an entry has to fit it; the report may end before the last one.
  const auto entry_number = [&](const char* name, BitNumber& into) {
    const auto place = at.at(name);
    auto number = BitNumber::parse(place.text(k_longest_text));
    if (!number) {
      place.fail(number.error().what, number.error().remedy);
    } else if (number->reach() > list.size) {
      place.fail("lies beyond its entry", "count bytes from the first of an entry, or raise `size`");
    } else {
      into = std::move(number).value();
    }
  };
  entry_number("id", list.id);
  entry_number("x", list.x);
  entry_number("y", list.y);
  list.down = read_test(at.at("down"));
  needs(list.from + list.size);
  layout_.contacts = std::move(list);
}

Layout read_layout(const JsonPlace& place) {
  Layout layout;
  const auto kind = place.at("gives").text();
  const auto* const known =
      std::find_if(k_kinds.begin(), k_kinds.end(), [&](const NamedKind& one) { return one.name == kind; });
  if (known == k_kinds.end()) {
    place.at("gives").fail("is no kind of report", "write pen, mouse, tool, leave, pad, touch, touch_pad or ignored");
    return layout;
  }
  layout.gives = known->gives;
  place.allow_only({"when",     "gives",       "shortest",      "x",           "y",        "pressure",
                    "tilt_x",   "tilt_y",      "distance",      "wheel",       "rotation", "buttons",
                    "tip",      "eraser",      "near",          "scroll",      "tool_id",  "serial",
                    "keys",     "key_codes",   "key_changed",   "key_down",    "ring",     "wheel_buttons",
                    "dial",     "second_dial", "eraser_button", "second_ring", "strip",    "second_strip",
                    "contacts", "battery",     "battery_full"});
  LayoutReader fields(place, layout);
  fields.number("x", layout.x);
  fields.number("y", layout.y);
  layout.last_pressure = fields.number_or("pressure", "last", layout.pressure);
  layout.last_tilt = fields.number_or("tilt_x", "last", layout.tilt_x);
  layout.last_tilt = fields.number_or("tilt_y", "last", layout.tilt_y) || layout.last_tilt;
  layout.last_buttons = fields.number_or("buttons", "last", layout.buttons);
  fields.number("distance", layout.distance);
  fields.number("wheel", layout.wheel);
  fields.rotation();
  fields.test("tip", layout.tip);
  fields.test("near", layout.near);
  if (const auto eraser = place.at("eraser"); eraser.is_text() && eraser.text(k_longest_text) == "tool") {
    layout.eraser_by_tool = true;
  } else {
    fields.test("eraser", layout.eraser);
  }
  if (const auto button = place.at("eraser_button"); button.present()) {
    layout.eraser_button = static_cast<int>(button.integer(1, 32));
  }
  fields.steps("scroll", layout.scroll);
  fields.number("tool_id", layout.tool_id);
  fields.number("serial", layout.serial);
  fields.number("keys", layout.keys);
  fields.number("key_changed", layout.changed_key);
  fields.test("key_down", layout.changed_key_down);
  fields.key_codes();
  fields.number("ring", layout.ring);
  fields.number("second_ring", layout.second_ring);
  fields.number("strip", layout.strip);
  fields.number("second_strip", layout.second_strip);
  fields.contacts();
  fields.number("wheel_buttons", layout.wheel_buttons);
  fields.steps("dial", layout.dial);
  fields.steps("second_dial", layout.second_dial);
  fields.number("battery", layout.battery);
  if (layout.battery && layout.gives != Gives::ignored)
    place.at("battery").fail("stands in a report of something else", "give it a report of kind ignored");
  if (const auto full = place.at("battery_full"); full.present()) layout.battery_full = full.integer(1, 65535);
  if (layout.gives == Gives::touch_pad) fields.needs(3);
  if (const auto shortest = place.at("shortest"); shortest.present()) {
    fields.needs(static_cast<std::size_t>(shortest.integer(0, k_longest_layout_report)));
  }
  return layout;
}

struct Shared {
  std::map<std::string, std::shared_ptr<const Layout>, std::less<>> layouts;
  std::map<std::string, std::vector<Protocol::Rule>, std::less<>> rule_lists;
};

void read_rule(const JsonPlace& place, const Shared& shared, std::vector<Protocol::Rule>& rules) {
  if (const auto include = place.at("include"); include.present()) {
    place.allow_only({"include"});
    const auto found = shared.rule_lists.find(include.text());
    if (found == shared.rule_lists.end()) {
      include.fail("names no rule list", "define it in rule_lists");
      return;
    }
    rules.insert(rules.end(), found->second.begin(), found->second.end());
    return;
  }
  Protocol::Rule rule;
  if (const auto when = place.at("when"); when.present()) rule.when = read_test(when);
  if (const auto use = place.at("use"); use.present()) {
    place.allow_only({"when", "use"});
    const auto found = shared.layouts.find(use.text());
    if (found == shared.layouts.end()) {
      use.fail("names no layout", "define it in layouts");
      return;
    }
    rule.layout = found->second;
  } else {
    rule.layout = std::make_shared<const Layout>(read_layout(place));
  }
  rules.push_back(std::move(rule));
}

std::vector<Protocol::Rule> read_rules(const JsonPlace& place, const Shared& shared) {
  constexpr std::size_t k_most_rules = 256;
  std::vector<Protocol::Rule> rules;
  for (const auto& item : place.items()) {
    read_rule(item, shared, rules);
    if (rules.size() <= k_most_rules) continue;
    place.fail("has more than 256 rules", "leave some out");
    break;
  }
  return rules;
}

}  // namespace

ProtocolMap read_protocols(const JsonPlace& file) {
  constexpr std::size_t k_most_protocols = 1000;
  Shared shared;
  for (const auto& [name, place] : file.at("layouts").members()) {
    if (const auto when = place.at("when"); when.present()) when.fail("belongs to a rule", "write it beside `use`");
    shared.layouts[name] = std::make_shared<const Layout>(read_layout(place));
  }
  for (const auto& [name, place] : file.at("rule_lists").members()) {
    shared.rule_lists[name] = read_rules(place, shared);
  }
  ProtocolMap protocols;
  const auto list = file.at("protocols").members();
  if (list.size() > k_most_protocols) file.at("protocols").fail("has more than 1000 protocols", "split the file");
  for (const auto& [name, place] : list) {
    auto protocol = std::make_shared<Protocol>();
    if (const auto like = place.at("like"); like.present()) {
      const auto found = protocols.find(like.text());
      if (found == protocols.end()) {
        like.fail("names no protocol", "put the protocol that it names before this one");
        return protocols;
      }
      *protocol = *found->second;
    }
    place.allow_only({"like", "skip", "shortest", "tip_above", "rules", "variants"});
    protocol->name = name;
    if (const auto at = place.at("skip"); at.present()) protocol->skip = static_cast<std::size_t>(at.integer(0, 64));
    if (const auto at = place.at("shortest"); at.present()) {
      protocol->shortest = static_cast<std::size_t>(at.integer(0, k_longest_layout_report));
    }
    if (const auto at = place.at("tip_above"); at.present()) protocol->tip_above = at.integer(0, 1'000'000);
    if (const auto at = place.at("rules"); at.present()) protocol->rules = read_rules(at, shared);
    for (const auto& variant : place.at("variants").items()) {
      variant.allow_only({"when", "like"});
      const auto found = protocols.find(variant.at("like").text());
      if (found == protocols.end()) {
        variant.at("like").fail("names no protocol", "put the protocol that it names before this one");
        return protocols;
      }
      protocol->variants.push_back({read_test(variant.at("when")), found->second->rules});
    }
    if (protocol->rules.empty()) place.fail("has no rules", "add rules, or name another protocol in like");
    protocols[name] = std::move(protocol);
  }
  return protocols;
}

}  // namespace penpose::decode
