// make_session demo SKETCH EXPRESSIONS OUT: a session that sketches the deformers of a sketch file on the built-in head
// and poses it as an expression file says, every line drawn by the virtual pen.
// make_session again SESSION OUT: a session of another edition by the one of today: the same strokes and commands, with
// the states that they come to now.
// make_session sketches SESSION OUT: the sketch file of the controls that a session ends with.
// make_session random SEED ACTIONS OUT: what a random hand does with a small sheet.

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

#include "core/base/edition.h"
#include "core/character/character.h"
#include "core/document/commands/command_text.h"
#include "core/document/commands/text_form.h"
#include "core/head/head.h"
#include "core/io/project/sketch_file.h"
#include "replay/session/session_player.h"
#include "tests/support/random_session.h"
#include "tests/tools/expression_file.h"

namespace {

using namespace penpose;  // NOLINT(google-build-using-namespace): a program of one file
using geometry::PxPoint;

std::string read(const char* path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

void stop(const base::Error& error, const std::string& where) {
  std::cerr << where << ": " << error.line() << '\n';
  std::exit(1);
}

class DemoHand {
 public:
  explicit DemoHand(tests::SessionScript& script) : script_(script) {}

  void look(const geometry::CameraPose& camera, geometry::Viewport viewport) {
    const document::View view{camera, viewport};
    if (view == script_.editor().view()) return;
    if (const auto done = script_.act(replay::ViewChanged{view}); !done) stop(done.error(), "view");
  }
  void draw(const std::vector<PxPoint>& line, const std::string& what) {
    if (const auto done = script_.stroke(line, 0.6); !done) stop(done.error(), what);
  }
  void perform(const document::Command& command, const std::string& what) {
    if (const auto done = script_.perform(command); !done) stop(done.error(), what);
  }

  void sketch(const articulation::Sketch& sketch) {
    perform(document::BeginDeformer{sketch.name, sketch.mode, sketch.surface, sketch.minimum, sketch.maximum},
            sketch.name);
    drawing::Tool tool;
    tool.kind = drawing::ToolKind::articulate;
    tool.draw_reference = !sketch.reference.empty();
    if (!(tool == script_.editor().tool())) static_cast<void>(script_.act(replay::ToolChosen{tool}));
    look(sketch.camera, sketch.viewport);
    draw(sketch.general, sketch.name + ", general");
    draw(sketch.specific, sketch.name + ", specific");
    if (tool.draw_reference) {
      look(sketch.reference_camera.value_or(sketch.camera), sketch.viewport);
      draw(sketch.reference, sketch.name + ", reference");
    }
    look(sketch.target_camera.value_or(sketch.camera), sketch.viewport);
    draw(sketch.target, sketch.name + ", target");
  }

  /// References first, all on the face at rest, then where they go, then the keys: reached, held, left.
  void pose(const tests::Expression& expression, geometry::Viewport viewport, double from_s) {
    perform(document::ClearCurves{}, expression.name);
    perform(document::ResetParameters{}, expression.name);
    perform(document::SetKey{from_s, ""}, expression.name);
    for (const auto kind : {drawing::ToolKind::reference, drawing::ToolKind::target}) {
      drawing::Tool tool;
      tool.kind = kind;
      static_cast<void>(script_.act(replay::ToolChosen{tool}));
      for (const tests::DrawnPair& pair : expression.curves) {
        look(pair.camera.value_or(expression.camera), viewport);
        draw(kind == drawing::ToolKind::reference ? pair.reference : pair.target, expression.name);
      }
    }
    perform(document::SetKey{from_s + 0.5, expression.name}, expression.name);
    perform(document::SetKey{from_s + 1.25, ""}, expression.name);
  }

 private:
  tests::SessionScript& script_;
};

base::Result<document::Document> open_model(const std::string& path) {
  if (path == "test-sheet") return document::make_document(tests::sheet_model());
  auto made = character::Character::built_in(path);
  if (!made) return made.error();
  return made->document();
}

/// Lines of a text, their ends kept.
std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find('\n', from), text.size() - 1) + 1;
    lines.push_back(text.substr(from, end - from));
    from = end;
  }
  return lines;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line;
  return text;
}

/// Writes down the state after every step.
class States final : public replay::PlayerObserver {
 public:
  std::vector<std::string> lines;
  void on_step(replay::Session& session, const replay::SessionStep&) override {
    lines.push_back("# " + replay::to_text(replay::StateReached{session.editor().state()}) + '\n');
  }
};

std::string session_again(const char* session_file) {
  std::vector<std::string> lines = lines_of(read(session_file));
  for (std::string& line : lines) {
    line = std::regex_replace(line, std::regex("^# penpose session \\S+"),
                              "# penpose session edition=" + std::to_string(base::k_edition));
    line = std::regex_replace(line, std::regex("(builtin%3A(head|demo))-[0-9]"), "$1");
    if (line.starts_with("# penpose ")) line = std::regex_replace(line, std::regex(" rules=[0-9]+"), "");
    std::smatch model;
    if (!std::regex_match(line, model, std::regex("# penpose model \\S+ path=(\\S+)\n"))) continue;
    const auto path = document::unescape(model[1].str());
    const auto opened = path ? open_model(*path) : base::Result<document::Document>(base::Error{"no model", "", ""});
    if (!opened) stop(opened.error(), session_file);
    line = "# " + replay::to_text(replay::ModelNamed{document::DocumentHasher()(*opened).whole, *path}) + '\n';
  }
  States states;
  replay::PlayerOptions options;
  options.open = open_model;
  options.observer = &states;
  const std::string text = joined(lines);
  const auto played = replay::play_session(replay::read_from(base::as_bytes(text)), options);
  if (!played) stop(played.error(), session_file);
  if (!played->problems.empty()) stop(played->problems.front(), session_file);
  for (const base::Error& refusal : played->refusals)
    std::cerr << session_file << ": refused: " << refusal.line() << '\n';
  const auto is_state = [](const std::string& line) { return line.starts_with("# penpose state "); };
  const auto count = static_cast<std::size_t>(std::count_if(lines.begin(), lines.end(), is_state));
  if (count > 0 && count != states.lines.size()) stop({"not every step has a state", "", ""}, session_file);
  std::size_t step = 0;
  for (std::string& line : lines) {
    if (is_state(line)) line = states.lines[step++];
  }
  return joined(lines);
}

/// The sketches of the controls that a session on the built-in head ends with.
std::string sketches_of(const char* session_file) {
  const std::string text = read(session_file);
  replay::PlayerOptions options;
  options.open = open_model;
  const auto played = replay::play_session(replay::read_from(base::as_bytes(text)), options);
  if (!played) stop(played.error(), session_file);
  io::SketchFile file;
  file.model = "builtin:head";
  for (const auto& deformer : played->session->editor().document().model->deformers->deformers()) {
    file.sketches.push_back(deformer->sketch());
  }
  file.viewport = file.sketches.front().viewport;
  return io::write_sketch_file(file);
}

std::string demo_session(const char* sketch_file, const char* expression_file) {
  const std::string sketch_text = read(sketch_file);
  const auto sketches = io::read_sketch_file(base::as_bytes(sketch_text));
  if (!sketches) stop(sketches.error(), sketch_file);
  const auto expressions = tests::read_expressions(read(expression_file));
  if (!expressions) stop(expressions.error(), expression_file);
  tests::SessionScript script(document::make_document(head::make_head()), "builtin:head");
  DemoHand hand(script);
  for (const articulation::Sketch& sketch : sketches->sketches) hand.sketch(sketch);
  double now_s = 0;
  for (const tests::Expression& expression : expressions->expressions) {
    hand.pose(expression, expressions->viewport, now_s);
    now_s += 1.75;
  }
  hand.perform(document::ClearCurves{}, "end");
  hand.perform(document::ResetParameters{}, "end");
  hand.perform(document::SetKey{now_s, ""}, "end");
  // Left at the first expression, which is what a picture of the file shows.
  hand.perform(document::GoToTime{0.5}, "end");
  return script.text();
}

}  // namespace

int main(int argc, char** argv) {
  const bool sketches = argc == 4 && std::strcmp(argv[1], "sketches") == 0;
  const bool again = argc == 4 && std::strcmp(argv[1], "again") == 0;
  if (argc != 5 && !sketches && !again) {
    std::cerr << "usage: make_session demo SKETCH EXPRESSIONS OUT | again SESSION OUT | sketches SESSION OUT | random "
                 "SEED ACTIONS OUT\n";
    return 2;
  }
  std::string text;
  if (again) {
    text = session_again(argv[2]);
  } else if (sketches) {
    text = sketches_of(argv[2]);
  } else if (std::strcmp(argv[1], "demo") == 0) {
    text = demo_session(argv[2], argv[3]);
  } else {
    tests::SessionScript script(document::make_document(tests::sheet_model()), "sheet");
    tests::RandomHand(script, std::strtoull(argv[2], nullptr, 10)).run(std::strtoull(argv[3], nullptr, 10));
    text = script.text();
  }
  std::ofstream(argv[argc - 1], std::ios::binary) << text;
  return 0;
}
