#include "tests/tools/expression_file.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

namespace penpose::tests {
namespace {

using Json = nlohmann::json;

/// The deepest nesting of a file that can be right is 7; what recurses deeper is refused before it costs stack.
constexpr int k_max_depth = 16;

/// Reads members and remembers the first thing that was wrong.
class Reader {
 public:
  [[nodiscard]] const std::optional<base::Error>& error() const { return error_; }

  void fail(const std::string& pointer, const std::string& what) {
    if (!error_) error_ = base::Error{what, pointer, "write it as the other expressions are written"};
  }
  const Json& member(const Json& object, const std::string& pointer, const char* name) {
    static const Json none;
    const auto found = object.is_object() ? object.find(name) : object.end();
    if (object.is_object() && found != object.end()) return *found;
    fail(pointer + "/" + name, "the key is missing");
    return none;
  }
  const Json& list(const Json& object, const std::string& pointer, const char* name) {
    static const Json none = Json::array();
    const Json& value = member(object, pointer, name);
    if (value.is_array()) return value;
    fail(pointer + "/" + name, "is not a list");
    return none;
  }
  double number(const Json& value, const std::string& pointer) {
    if (value.is_number()) return value.get<double>();
    fail(pointer, "is not a number");
    return 0;
  }
  template <std::size_t Count>
  std::array<double, Count> numbers(const Json& value, const std::string& pointer) {
    std::array<double, Count> out{};
    if (!value.is_array() || value.size() != Count) {
      fail(pointer, "is not a list of " + std::to_string(Count) + " numbers");
      return out;
    }
    for (std::size_t i = 0; i < Count; ++i) out[i] = number(value[i], pointer + "/" + std::to_string(i));
    return out;
  }
  std::vector<curve::PxPoint> stroke(const Json& object, const std::string& pointer, const char* name) {
    std::vector<curve::PxPoint> points;
    const std::string place = pointer + "/" + name;
    for (const Json& value : list(object, pointer, name)) {
      const auto xy = numbers<2>(value, place + "/" + std::to_string(points.size()));
      points.push_back({xy[0], xy[1]});
    }
    if (points.size() < 2) fail(place, "a line needs two points");
    return points;
  }
  geometry::CameraPose camera(const Json& object, const std::string& pointer) {
    const Json& value = member(object, pointer, "camera");
    const std::string place = pointer + "/camera";
    const auto vector = [&](const char* name) {
      const auto xyz = numbers<3>(member(value, place, name), place + "/" + name);
      return geometry::ModelPoint{xyz[0], xyz[1], xyz[2]};
    };
    geometry::CameraPose pose;
    pose.eye = vector("eye");
    pose.look_at = vector("look_at");
    pose.up = vector("up");
    pose.vertical_fov_degrees = number(member(value, place, "vertical_fov_degrees"), place + "/vertical_fov_degrees");
    return pose;
  }

 private:
  std::optional<base::Error> error_;
};

Expression read_expression(Reader& reader, const Json& value, const std::string& pointer) {
  Expression expression;
  const Json& name = reader.member(value, pointer, "name");
  if (name.is_string()) expression.name = name.get<std::string>();
  if (expression.name.empty()) reader.fail(pointer + "/name", "is not a name");
  expression.camera = reader.camera(value, pointer);
  for (const Json& pair : reader.list(value, pointer, "curves")) {
    const std::string place = pointer + "/curves/" + std::to_string(expression.curves.size());
    DrawnPair& drawn = expression.curves.emplace_back();
    drawn.reference = reader.stroke(pair, place, "reference");
    drawn.target = reader.stroke(pair, place, "target");
    if (pair.is_object() && pair.contains("camera")) drawn.camera = reader.camera(pair, place);
  }
  if (expression.curves.empty()) reader.fail(pointer + "/curves", "there is no curve");
  return expression;
}

}  // namespace

base::Result<ExpressionFile> read_expressions(std::string_view text) {
  bool too_deep = false;
  const Json root = Json::parse(
      text,
      [&](int depth, Json::parse_event_t, Json&) {
        too_deep = too_deep || depth > k_max_depth;
        return !too_deep;
      },
      false);
  if (root.is_discarded() || too_deep)
    return base::Error{"this is not JSON that holds expressions", "", "check the file"};
  Reader reader;
  ExpressionFile file;
  const auto size = reader.numbers<2>(reader.member(root, "", "viewport"), "/viewport");
  for (std::size_t i = 0; i < 2; ++i) {
    if (!(size[i] >= 1 && size[i] <= 100000)) reader.fail("/viewport/" + std::to_string(i), "is no size in px");
  }
  if (reader.error()) return *reader.error();
  file.viewport = {static_cast<int>(size[0]), static_cast<int>(size[1])};
  for (const Json& value : reader.list(root, "", "expressions")) {
    const std::string pointer = "/expressions/" + std::to_string(file.expressions.size());
    Expression expression = read_expression(reader, value, pointer);
    const bool taken = std::any_of(file.expressions.begin(), file.expressions.end(),
                                   [&](const Expression& other) { return other.name == expression.name; });
    if (taken) reader.fail(pointer + "/name", "the name is there twice");
    if (reader.error()) return *reader.error();
    file.expressions.push_back(std::move(expression));
  }
  if (reader.error()) return *reader.error();
  return file;
}

}  // namespace penpose::tests
