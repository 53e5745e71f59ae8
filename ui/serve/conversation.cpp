#include "ui/serve/conversation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <stdexcept>

#include "core/base/version.h"
#include "core/document/commands/command_text.h"
#include "core/tracking/animate.h"
#include "ui/serve/animation_json.h"
#include "ui/serve/drawing_json.h"
#include "ui/serve/internal/pose_json.h"
#include "ui/serve/internal/request.h"

namespace penpose::serve {
namespace {

using document::CurveId;

const std::string k_program = "penpose-serve-" + std::string(base::k_version);

std::optional<bool> constraint_of(std::string_view role) {
  if (role == "reference") return false;
  if (role == "constraint") return true;
  return std::nullopt;
}

std::vector<mesh::MeshPoint> mesh_points(const Request& request) {
  const auto numbers = request.rows("points", 4);
  std::vector<mesh::MeshPoint> points;
  for (std::size_t i = 0; i < numbers.size(); i += 4) {
    const bool is_number = numbers[i] >= 0 && numbers[i] <= 4294967295.0 && numbers[i] == std::floor(numbers[i]);
    if (!is_number) {
      refuse("the number of a triangle was expected", json::child(request.at("points"), i / 4),
             "give [triangle, share, share, share]");
    }
    points.push_back({static_cast<std::uint32_t>(numbers[i]), {numbers[i + 1], numbers[i + 2], numbers[i + 3]}});
  }
  return points;
}

std::vector<document::NamedValue> named_values(const Request& request) {
  const Json& values = request.need("parameters");
  if (!values.is_object()) refuse("an object of names and values was expected", request.at("parameters"), "give one");
  std::vector<document::NamedValue> out;
  for (const auto& [name, value] : values.items()) {
    const auto number = json::number(value);
    if (!number) refuse("a number was expected", json::child(request.at("parameters"), name), "give one");
    out.push_back({name, *number});
  }
  return out;
}

/// One of three words, the first where the request has none.
template <typename T>
T choice(const Request& request, const std::string& member, const std::array<std::pair<std::string, T>, 3>& words) {
  const std::string word = request.text_or(member.c_str(), words[0].first);
  for (const auto& [one, meaning] : words) {
    if (one == word) return meaning;
  }
  refuse("there is no such " + member, request.at(member.c_str()),
         "give " + words[0].first + ", " + words[1].first + " or " + words[2].first);
}

articulation::Mode mode_of(const Request& request) {
  using articulation::Mode;
  return choice<Mode>(request, "mode",
                      {{{"auto", Mode::automatic}, {"translate", Mode::translate}, {"rotate", Mode::rotate}}});
}

character::Preset preset_of(const Request& request) {
  using character::Preset;
  return choice<Preset>(request, "preset",
                        {{{"default", Preset::meant}, {"exact", Preset::exact}, {"paper", Preset::paper}}});
}

void done(const base::Status& status) {
  if (!status) throw Refusal{status.error()};
}

}  // namespace

/// What lines ask for: each takes the line and gives members of the answer.
struct Conversation::Actions {
  Conversation& talk;
  const Request& request;

  character::Character& one() {
    if (!talk.character_) refuse("no character is loaded", "/do", "load one first");
    return *talk.character_;
  }

  Json load() {
    request.allow({"do", "id", "model"});
    const std::string model = request.text_or("model", "builtin:head");
    if (talk.files_.record && talk.character_)
      refuse("a session is recorded on one character", "/do", "begin another conversation");
    character::Character loaded(taken(talk.files_.load(model)));
    Json parameters = Json::array();
    for (const rig::Parameter& p : loaded.parameters())
      parameters.push_back({{"name", p.name}, {"minimum", p.minimum}, {"rest", p.rest}, {"maximum", p.maximum}});
    Json curves = Json::array();
    for (const auto& curve : loaded.document().model->curves) curves.push_back(curve.name);
    Json answer = {{"vertices", loaded.vertex_count()},
                   {"triangles", loaded.document().model->mesh->triangle_count()},
                   {"parameters", std::move(parameters)},
                   {"curves", std::move(curves)},
                   {"state", loaded.state().whole.hex()}};
    if (talk.files_.record) {
      replay::CommandRecorder recorder{std::string(k_program)};
      done(talk.files_.record(recorder.begin(loaded.document(), model)));
      talk.recorder_ = std::move(recorder);
    }
    talk.character_.emplace(std::move(loaded));
    talk.listen();
    return answer;
  }

  Json curve() {
    request.allow({"do", "id", "vertices", "points", "name", "view", "line", "role"});
    const auto constraint = constraint_of(request.text_or("role", "reference"));
    if (!constraint) refuse("there is no such role", request.at("role"), "give reference or constraint");
    const int ways =
        int{request.has("vertices")} + int{request.has("points")} + int{request.has("name")} + int{request.has("line")};
    if (ways != 1) refuse("one way to say the curve was expected", "", "give vertices, points, name, or view and line");
    CurveId id;
    if (request.has("line")) {
      const document::View view = request.view("view");
      const auto line = request.line("line");
      id = taken(*constraint ? one().draw_constraint(view, line) : one().draw_reference(view, line));
    } else {
      const auto points = request.has("vertices") ? taken(one().points_at(request.wholes("vertices")))
                          : request.has("name")   ? taken(one().points_of(request.text("name")))
                                                  : mesh_points(request);
      id = taken(*constraint ? one().place_constraint(points) : one().place_reference(points));
    }
    Json positions = Json::array();
    for (const auto& p : taken(one().positions_of(id))) positions.push_back(to_json(p));
    return {{"curve", id.value}, {"positions", std::move(positions)}};
  }

  Json target() {
    request.allow({"do", "id", "curve", "points", "view", "line", "pressure"});
    const CurveId id{request.whole("curve")};
    if (request.has("points") == request.has("line"))
      refuse("one way to say the target was expected", "", "give points, or view and line");
    if (request.has("points")) {
      done(one().place_target(id, request.points("points")));
      return Json::object();
    }
    const auto pressure = request.has("pressure") ? request.numbers("pressure") : std::vector<double>();
    done(one().draw_target(id, request.view("view"), request.line("line"), pressure));
    return solved();
  }

  Json solve() {
    request.allow({"do", "id", "preset"});
    done(one().solve(preset_of(request)));
    return solved();
  }

  Json solved() { return {{"parameters", pose_json(one())}, {"distances", distances_json(one())}}; }

  Json draw() {
    request.allow({"do", "id", "lines", "neutral", "view"});
    portrait::Drawing drawing{request.lines("lines"), {}};
    if (request.has("neutral")) drawing.neutral = request.lines("neutral");
    const auto view = request.has("view") ? std::optional(request.view("view")) : std::nullopt;
    const auto drawn = taken(one().draw_face(drawing, view));
    const auto rows = [&](const std::vector<portrait::LineRead>& lines) {
      Json out = Json::array();
      for (const portrait::LineRead& line : lines) out.push_back(line_json(line, drawn.features.curves));
      return out;
    };
    Json answer = {{"parameters", pose_json(one())}, {"lines", rows(drawn.read.lines)}};
    if (request.has("neutral")) answer["neutral_lines"] = rows(drawn.read.neutral);
    return answer;
  }

  Json sketch() {
    request.allow({"do", "id", "name", "view", "target_view", "general", "specific", "reference", "target", "mode",
                   "minimum", "maximum"});
    articulation::Sketch sketch;
    sketch.name = request.text_or("name", "");
    const document::View view = request.view("view");
    sketch.camera = view.camera;
    sketch.viewport = view.viewport;
    if (request.has("target_view")) {
      const document::View own = request.view("target_view");
      if (!(own.viewport == view.viewport))
        refuse("the target's picture has another size", request.at("target_view"), "draw it on one as large");
      if (!(own.camera == view.camera)) sketch.target_camera = own.camera;
    }
    sketch.general = request.line("general");
    sketch.specific = request.line("specific");
    if (request.has("reference")) sketch.reference = request.line("reference");
    sketch.target = request.line("target");
    sketch.mode = mode_of(request);
    sketch.minimum = request.number_or("minimum", 0);
    sketch.maximum = request.number_or("maximum", 1);
    done(one().sketch(sketch));
    return {{"parameter", one().document().model->deformers->parameters().back().name}};
  }

  Json set() {
    request.allow({"do", "id", "parameters"});
    done(one().perform(document::SetParameters{named_values(request)}));
    return {{"parameters", pose_json(one())}};
  }

  Json perform() {
    request.allow({"do", "id", "command"});
    done(one().perform(taken(document::parse_command(request.text("command")))));
    return {{"parameters", pose_json(one())}};
  }

  Json evaluate() {
    request.allow({"do", "id", "parameters", "vertices"});
    rig::Pose pose = one().pose();
    if (request.has("parameters")) {
      for (const document::NamedValue& value : named_values(request)) {
        const auto found = rig::find_parameter(one().parameters(), value.name);
        if (!found) refuse("there is no such parameter", "/parameters/" + value.name, "load lists them");
        pose[*found] = value.value;
      }
    }
    std::vector<geometry::ModelPoint> positions(one().vertex_count());
    one().evaluate(pose, positions);
    Json out = Json::array();
    if (!request.has("vertices")) {
      for (const auto& p : positions) out.push_back(to_json(p));
      return {{"positions", std::move(out)}};
    }
    for (const std::uint32_t vertex : request.wholes("vertices")) {
      if (vertex >= positions.size())
        refuse("there is no vertex " + std::to_string(vertex), request.at("vertices"), "load says how many there are");
      out.push_back(to_json(positions[vertex]));
    }
    return {{"positions", std::move(out)}};
  }

  Json view() {
    request.allow({"do", "id", "yaw", "pitch", "width", "height"});
    constexpr std::uint32_t k_usual_px = 1000;
    const auto side = [&](const char* name) {
      const std::uint32_t px = request.whole_or(name, k_usual_px);
      if (px < 1 || px > 32768) refuse("no side of a picture", request.at(name), "give 1 to 32768 px");
      return static_cast<int>(px);
    };
    const auto angle = [&](const char* name) {
      const double degrees = request.number_or(name, 0);
      if (!(std::abs(degrees) <= 1e6)) refuse("the angle is too large", request.at(name), "give degrees");
      return degrees;
    };
    return {{"view", to_json(one().view_from(angle("yaw"), angle("pitch"), {side("width"), side("height")}))}};
  }

  Json state() {
    request.allow({"do", "id"});
    return {{"state", one().state().whole.hex()}};
  }

  Json save() {
    request.allow({"do", "id", "path"});
    const std::string path = request.text("path");
    const auto bytes = taken(one().write(path));
    done(talk.files_.save(path, bytes));
    return {{"bytes", bytes.size()}};
  }

  Json animate() {
    request.allow({"do", "id", "track", "map", "curves", "head", "neutral", "tremor", "smooth", "confidence", "fps",
                   "stretch", "picture", "units"});
    if (talk.files_.record)
      refuse("an animation is no command that a session can hold", "/do", "begin a conversation that is not recorded");
    const tracking::AnimateOptions options = animate_options();
    auto map = request.has("map") ? std::optional(map_named(request.text("map"))) : std::nullopt;
    auto read = taken(talk.files_.track(request.text("track"), map ? map->format : nullptr, picture()));
    if (!map) map = taken(io::read_bundled_map(*read.format));
    auto animated = taken(tracking::animate(one().document(), std::move(read.track), *map, options));
    Json answer = animation_json(animated);
    answer["times"] = animated.times_s;
    answer["notes"] = animated.notes;
    talk.character_.emplace(std::move(animated.document));
    talk.listen();
    return answer;
  }

  io::MapFile map_named(const std::string& name) {
    if (const io::TrackFormat* named = io::track_format_named(name)) return taken(io::read_bundled_map(*named));
    return taken(io::read_map_file(taken(talk.files_.read(name))));
  }

  std::optional<io::PictureSize> picture() {
    if (!request.has("picture")) return std::nullopt;
    const auto sides = request.wholes("picture");
    constexpr std::uint32_t k_widest_px = 100000;
    const bool fits =
        sides.size() == 2 && std::min(sides[0], sides[1]) > 0 && std::max(sides[0], sides[1]) <= k_widest_px;
    if (!fits) refuse("the size of a picture was expected", request.at("picture"), "give [width, height] in px");
    return io::PictureSize{static_cast<double>(sides[0]), static_cast<double>(sides[1])};
  }

  tracking::AnimateOptions animate_options() {
    tracking::AnimateOptions options;
    if (request.has("head")) {
      const std::string head = request.text("head");
      if (head != "drop" && head != "apply")
        refuse("there is no such choice", request.at("head"), "give drop or apply");
      options.apply_head = head == "apply";
    }
    if (request.has("neutral")) options.neutral = request.whole("neutral");
    if (request.has("tremor")) options.tremor_px = request.number_or("tremor", 0);
    options.smooth_s = request.number_or("smooth", options.smooth_s);
    options.least_confidence = request.number_or("confidence", options.least_confidence);
    options.fps = request.number_or("fps", options.fps);
    options.stretch = request.number_or("stretch", options.stretch);
    options.units = request.truth_or("units", false);
    if (request.has("curves"))
      options.curves = taken(io::read_landmarks(taken(talk.files_.read(request.text("curves")))));
    return options;
  }

  Json run() {
    using Action = Json (Actions::*)();
    constexpr std::array<std::pair<std::string_view, Action>, 13> k_actions{{{"load", &Actions::load},
                                                                             {"curve", &Actions::curve},
                                                                             {"target", &Actions::target},
                                                                             {"solve", &Actions::solve},
                                                                             {"draw", &Actions::draw},
                                                                             {"sketch", &Actions::sketch},
                                                                             {"animate", &Actions::animate},
                                                                             {"set", &Actions::set},
                                                                             {"perform", &Actions::perform},
                                                                             {"evaluate", &Actions::evaluate},
                                                                             {"view", &Actions::view},
                                                                             {"state", &Actions::state},
                                                                             {"save", &Actions::save}}};
    const std::string wanted = request.text("do");
    std::string known;
    for (const auto& [name, action] : k_actions) {
      if (name == wanted) return (this->*action)();
      known += (known.empty() ? "" : ", ") + std::string(name);
    }
    refuse("there is nothing of that name to do", "/do", "known are: " + known);
  }
};

Conversation::Conversation(Files files) : files_(std::move(files)), recorder_(std::string(k_program)) {}

void Conversation::listen() {
  if (!files_.record) return;
  character_->listen([this](std::span<const document::Command> commands, std::span<const document::Document> after) {
    // What cannot be written down is not done, so that the session is all that was.
    replay::CommandRecorder next = recorder_;
    auto written = files_.record(next.lines(commands, after));
    if (written) recorder_ = std::move(next);
    return written;
  });
}

std::string Conversation::answer(std::string_view line) {
  Json out = {{"ok", false}};
  const auto say = [&](const base::Error& error) { out["error"] = error.line(); };
  try {
    if (line.size() > k_longest_line) refuse("the line is too long", "", "give at most 64 MB");
    auto parsed = json::parse_json(base::as_bytes(line));
    if (!parsed) refuse("the line is no JSON", parsed.error().place, "write one object, {\"do\": ...}");
    const Json json = std::move(parsed).value();
    if (!json.is_object()) refuse("an object was expected", "", "write {\"do\": ...}");
    if (const auto id = json.find("id"); id != json.end()) out["id"] = *id;
    const Request request{json, ""};
    Json members = Actions{*this, request}.run();
    out["ok"] = true;
    out.update(members);
  } catch (const Refusal& refusal) {
    say(refusal.error);
  } catch (const std::bad_alloc&) {
    if (character_) character_->forget_scratch();
    say({"the memory does not suffice", "", "give the program more of it, or ask for less"});
  } catch (const std::length_error&) {
    if (character_) character_->forget_scratch();
    say({"the memory cannot suffice", "", "ask for less"});
  }
  return out.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace penpose::serve
