#include <algorithm>
#include <charconv>

#include "core/base/json/json_value.h"

namespace penpose::json {
namespace {

/// Takes what nlohmann's reader meets. What is read is in its place at once, so that nothing is lost where memory runs
/// out.
class Builder : public nlohmann::json_sax<Json> {
 public:
  Builder(Json& root, std::size_t deepest) : root_(root), deepest_(deepest) {}

  bool null() override { return put(nullptr); }
  bool boolean(bool value) override { return put(value); }
  bool number_integer(std::int64_t value) override { return put(value); }
  bool number_unsigned(std::uint64_t value) override { return put(value); }
  /// `text` has the point of the process's locale, which would stop the reading of `value` where a thread changes it.
  bool number_float(double value, const std::string& text) override {
    std::string digits = text;
    const auto point = digits.find_first_not_of("+-0123456789eE");
    if (point != std::string::npos) digits[point] = '.';
    std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return put(value);
  }
  bool string(std::string& text) override { return put(std::move(text)); }
  bool binary(Json::binary_t&) override { return false; }  // JSON has none
  bool start_object(std::size_t) override { return open(Json::object()); }
  bool start_array(std::size_t) override { return open(Json::array()); }
  bool key(std::string& name) override {
    member_ = &(*open_.back())[std::move(name)];
    return true;
  }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& error) override {
    constexpr int k_too_large = 406;
    refused_ = {error.id == k_too_large ? Refused::Why::number : Refused::Why::text, position > 0 ? position - 1 : 0};
    return false;
  }

  [[nodiscard]] const Refused& refused() const { return refused_; }

 private:
  /// Where the next value goes. Only the innermost container grows, so that pointers to those around it stay good.
  Json& place() {
    if (open_.empty()) return root_;
    Json& inner = *open_.back();
    if (inner.is_object()) return *member_;
    inner.push_back(nullptr);
    return inner.back();
  }
  bool put(Json value) {
    place() = std::move(value);
    return true;
  }
  bool open(Json container) {
    if (open_.size() == deepest_) {
      refused_.why = Refused::Why::depth;
      return false;
    }
    Json& into = place();
    into = std::move(container);
    open_.push_back(&into);
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  Json& root_;
  std::size_t deepest_;
  std::vector<Json*> open_;
  Json* member_ = nullptr;  ///< of the innermost object, whose value comes next
  Refused refused_{};
};

/// Where the bracket stands that opens one level too many, in a text that is JSON until there.
std::size_t too_deep_at(std::string_view text, std::size_t deepest) {
  bool quoted = false;
  std::size_t deep = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"') quoted = !quoted;
    if (quoted) {
      i += c == '\\' ? 1 : 0;
    } else if (c == '[' || c == '{') {
      if (deep++ == deepest) return i;
    } else if (c == ']' || c == '}') {
      --deep;
    }
  }
  return text.size();
}

}  // namespace

std::optional<Refused> read_json(std::string_view text, std::size_t deepest, Json& into) {
  Builder builder(into, deepest);
  if (Json::sax_parse(text.data(), text.data() + text.size(), &builder)) return std::nullopt;
  Refused refused = builder.refused();
  if (refused.why == Refused::Why::depth) refused.offset = too_deep_at(text, deepest);
  return refused;
}

}  // namespace penpose::json
