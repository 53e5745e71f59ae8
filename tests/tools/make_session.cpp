// make_session demo SKETCH EXPRESSIONS OUT: a session that sketches the deformers of a sketch file on the built-in head
// and poses it as an expression file says, every line drawn by the virtual pen.
// make_session sketches SESSION OUT: the sketch file of the controls that a session ends with.
// make_session random SEED ACTIONS OUT: what a random hand does with a small sheet.

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <iterator>

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

/// The sketches of the controls that a session on the built-in head ends with.
std::string sketches_of(const char* session_file) {
  const std::string text = read(session_file);
  replay::PlayerOptions options;
  options.open = [](const std::string&) {
    return base::Result<document::Document>(document::make_document(head::make_head()));
  };
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
  if (argc != 5 && !sketches) {
    std::cerr << "usage: make_session demo SKETCH EXPRESSIONS OUT | sketches SESSION OUT | random SEED ACTIONS OUT\n";
    return 2;
  }
  std::string text;
  if (sketches) {
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
