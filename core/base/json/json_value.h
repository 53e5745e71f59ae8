#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace penpose::json {

// NOLINTBEGIN(readability-identifier-naming): names that tinygltf's source, compiled with this type, asks for

/// A JSON value whose freeing takes no memory, so that a parse or a file half made is given back also where there is
/// none: nlohmann's value lists what it holds before it frees it, and ends the program where that fails. Names and
/// meanings are those of nlohmann's that are needed here. Members of objects are ordered by name; in which order they
/// were made is known, too.
class Json {
 public:
  enum class value_t : std::uint8_t {
    null,
    boolean,
    number_integer,
    number_unsigned,
    number_float,
    string,
    array,
    object,
    binary,     ///< never made
    discarded,  ///< never made
  };
  using array_t = std::vector<Json>;
  using object_t = std::map<std::string, Json, std::less<>>;
  class const_iterator;
  struct Item;
  enum class error_handler_t : std::uint8_t { replace };

  /// Why a text is refused: it is no JSON, has a number that no double holds, or is nested too deep.
  enum class Fault : std::uint8_t { text, number, depth };
  struct parse_error : std::runtime_error {
    parse_error(std::size_t at, Fault why) : std::runtime_error("no JSON"), byte(at), fault(why) {}
    std::size_t byte;  ///< from 1; that behind the last one where the text ends too soon
    Fault fault;
  };
  /// A value is asked for as what it is not.
  struct type_error : std::logic_error {
    type_error() : std::logic_error("a JSON value is of another type") {}
  };

  Json(std::nullptr_t = nullptr) noexcept {}
  template <typename T>
  requires std::is_arithmetic_v<T> Json(T value)
  noexcept {
    if constexpr (std::same_as<T, bool>) {
      type_ = value_t::boolean;
      held_.boolean = value;
    } else if constexpr (std::floating_point<T>) {
      type_ = value_t::number_float;
      held_.real = static_cast<double>(value);
    } else if constexpr (std::is_signed_v<T>) {
      type_ = value_t::number_integer;
      held_.integer = value;
    } else {
      type_ = value_t::number_unsigned;
      held_.natural = value;
    }
  }
  Json(std::string text);
  Json(std::string_view text) : Json(std::string(text)) {}
  Json(const char* text) : Json(std::string(text)) {}
  template <typename T>
  requires std::constructible_from<Json, const T&> Json(const std::vector<T>& list) : Json(array()) {
    held_.list->reserve(list.size());
    for (const auto& one : list) held_.list->emplace_back(one);
  }
  template <typename T, std::size_t count>
  requires std::constructible_from<Json, const T&> Json(const std::array<T, count>& list)
      : Json(std::vector<T>(list.begin(), list.end())) {}
  /// A list; an object where every item is a list of a text and a value.
  Json(std::initializer_list<Item> items);

  Json(const Json& other);
  Json(Json&& other) noexcept { swap(other); }
  Json& operator=(Json other) noexcept {
    swap(other);
    return *this;
  }
  ~Json();

  [[nodiscard]] static Json array();
  [[nodiscard]] static Json array(std::initializer_list<Item> items);
  [[nodiscard]] static Json object();
  [[nodiscard]] static Json object(std::initializer_list<Item> items);
  /// `deepest`: levels of brackets at most. Throws parse_error.
  [[nodiscard]] static Json parse(std::string_view text, std::size_t deepest = static_cast<std::size_t>(-1));
  template <std::contiguous_iterator Iterator>
  requires(sizeof(std::iter_value_t<Iterator>) == 1) [[nodiscard]] static Json parse(Iterator first, Iterator last) {
    return parse(std::string_view(reinterpret_cast<const char*>(std::to_address(first)),
                                  static_cast<std::size_t>(last - first)));
  }
  /// As tinygltf asks for it: null where the text is no JSON.
  [[nodiscard]] static Json parse(const char* first, const char* last, std::nullptr_t, bool throws);

  [[nodiscard]] value_t type() const noexcept { return type_; }
  [[nodiscard]] bool is_null() const noexcept { return type_ == value_t::null; }
  [[nodiscard]] bool is_boolean() const noexcept { return type_ == value_t::boolean; }
  [[nodiscard]] bool is_string() const noexcept { return type_ == value_t::string; }
  [[nodiscard]] bool is_array() const noexcept { return type_ == value_t::array; }
  [[nodiscard]] bool is_object() const noexcept { return type_ == value_t::object; }
  [[nodiscard]] bool is_number_float() const noexcept { return type_ == value_t::number_float; }
  [[nodiscard]] bool is_number_unsigned() const noexcept { return type_ == value_t::number_unsigned; }
  /// With or without a sign.
  [[nodiscard]] bool is_number_integer() const noexcept {
    return type_ == value_t::number_integer || type_ == value_t::number_unsigned;
  }
  [[nodiscard]] bool is_number() const noexcept { return is_number_integer() || is_number_float(); }

  /// The number, truth or text. Throws type_error where it is of another kind.
  template <typename T>
  [[nodiscard]] T get() const {
    if constexpr (std::same_as<T, bool>) {
      if (!is_boolean()) throw type_error();
      return held_.boolean;
    } else if constexpr (std::is_arithmetic_v<T>) {
      if (is_number_float()) return static_cast<T>(held_.real);
      if (is_number_unsigned()) return static_cast<T>(held_.natural);
      if (!is_number_integer()) throw type_error();
      return static_cast<T>(held_.integer);
    } else {
      return text();
    }
  }
  template <typename T>
  requires std::same_as<T, const std::string&>
  [[nodiscard]] T get_ref() const { return text(); }

  /// Entries of a list or an object; 0 of null, else 1.
  [[nodiscard]] std::size_t size() const noexcept;
  [[nodiscard]] bool empty() const noexcept { return size() == 0; }
  [[nodiscard]] const_iterator begin() const;
  [[nodiscard]] const_iterator end() const;
  [[nodiscard]] const_iterator find(std::string_view name) const;
  [[nodiscard]] bool contains(std::string_view name) const;
  /// The members of an object; of anything else none.
  [[nodiscard]] const object_t& items() const noexcept;

  /// They in the order in which they were made or read.
  [[nodiscard]] std::vector<const object_t::value_type*> members_as_made() const;

  /// The member or entry; a member that is not there is made, also in what was null.
  [[nodiscard]] Json& operator[](std::string_view name);
  template <std::integral Index>
  [[nodiscard]] Json& operator[](Index index) {
    return list().at(static_cast<std::size_t>(index));
  }
  /// It has to be there.
  [[nodiscard]] const Json& operator[](std::string_view name) const { return at(name); }
  template <std::integral Index>
  [[nodiscard]] const Json& operator[](Index index) const {
    return at(static_cast<std::size_t>(index));
  }
  /// Throws std::out_of_range.
  [[nodiscard]] const Json& at(std::string_view name) const;
  [[nodiscard]] Json& at(std::string_view name);
  template <std::integral Index>
  [[nodiscard]] const Json& at(Index index) const {
    return list().at(static_cast<std::size_t>(index));
  }
  [[nodiscard]] const Json& front() const { return at(0); }
  [[nodiscard]] const Json& back() const { return at(size() - 1); }
  /// Also to what was null.
  void push_back(Json value);
  void erase(std::string_view name);
  /// Takes over the members of another object.
  void update(const Json& members);
  void swap(Json& other) noexcept {
    std::swap(type_, other.type_);
    std::swap(held_, other.held_);
  }

  /// As text, in one line, or `indent` spaces deeper with each level. What is no UTF-8 is replaced.
  [[nodiscard]] std::string dump(int indent = -1, char fill = ' ', bool ascii = false,
                                 error_handler_t handler = error_handler_t::replace) const;
  /// The same with members in the order in which they were made: for people, who read from left to right.
  [[nodiscard]] std::string dump_as_made(int indent = -1) const;

  /// Numbers are equal by their value.
  friend bool operator==(const Json& a, const Json& b);

 private:
  union Held {
    bool boolean;
    std::int64_t integer;
    std::uint64_t natural = 0;
    double real;
    std::string* text;
    array_t* list;
    object_t* members;
  };

  [[nodiscard]] const std::string& text() const;
  [[nodiscard]] array_t& list() const;
  enum class Order : bool { by_name, as_made };
  void write(std::string& out, int indent, std::size_t level, Order order) const;

  value_t type_ = value_t::null;
  std::uint32_t place_ = 0;  ///< of a member among those of its object, by when it was made; swap leaves it
  Held held_;
};

/// Entries of a list, or members of an object by their names.
class Json::const_iterator {
 public:
  using iterator_category = std::forward_iterator_tag;
  using value_type = Json;
  using difference_type = std::ptrdiff_t;
  using pointer = const Json*;
  using reference = const Json&;

  const_iterator() = default;
  explicit const_iterator(const Json* entry) : entry_(entry) {}
  explicit const_iterator(object_t::const_iterator member) : member_(member), of_object_(true) {}

  [[nodiscard]] const std::string& key() const { return member_->first; }
  [[nodiscard]] const Json& value() const { return of_object_ ? member_->second : *entry_; }
  const Json& operator*() const { return value(); }
  const Json* operator->() const { return &value(); }
  const_iterator& operator++() {
    if (of_object_) {
      ++member_;
    } else {
      ++entry_;
    }
    return *this;
  }
  const_iterator operator++(int) {
    const const_iterator before = *this;
    ++*this;
    return before;
  }
  friend bool operator==(const const_iterator& a, const const_iterator& b) {
    return a.of_object_ ? a.member_ == b.member_ : a.entry_ == b.entry_;
  }

 private:
  const Json* entry_ = nullptr;
  object_t::const_iterator member_;
  bool of_object_ = false;
};

/// What stands between braces: a value that can be moved out of them.
struct Json::Item {
  template <typename T>
  requires(std::constructible_from<Json, T&&> && !std::same_as<std::remove_cvref_t<T>, Item>) Item(T&& from)
      : value(std::forward<T>(from)) {}  // NOLINT(bugprone-forwarding-reference-overload): it is bounded
  Item(std::initializer_list<Item> items) : value(items) {}
  mutable Json value;
};

// NOLINTEND(readability-identifier-naming)

}  // namespace penpose::json
