// in_cpp SESSION[@MODEL]...: replays sessions through the C++ libraries and prints "NAME STATE" of each; then poses the
// demo's head and prints how far it came.
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <penpose.hpp>
#include <string>
#include <vector>

namespace {

int fail(const std::string& line) {
  std::fprintf(stderr, "%s\n", line.c_str());
  return 1;
}

std::string read_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

int replay(const std::string& argument) {
  const std::string path = argument.substr(0, argument.find('@'));
  const std::string model = path == argument ? "" : argument.substr(path.size() + 1);
  const std::string text = read_text(path);
  penpose::replay::PlayerOptions options;
  options.open = [&](const std::string& name) -> penpose::base::Result<penpose::document::Document> {
    const std::string bytes = model.empty() ? "" : read_text(model);
    auto made =
        model.empty() ? penpose::Character::built_in(name) : penpose::Character::read(penpose::base::as_bytes(bytes));
    if (!made) return made.error();
    return made->document();
  };
  auto played = penpose::replay::play_session(penpose::replay::read_from(penpose::base::as_bytes(text)), options);
  if (!played) return fail(played.error().line(path));
  if (!played->session || played->divergence) return fail(path + " diverges");
  const std::string state = played->session->editor().state().whole.hex();
  std::printf("%s %s\n", path.substr(path.rfind('/') + 1).c_str(), state.c_str());
  return 0;
}

/// A take of two frames opens the jaw.
bool animates(const penpose::document::Document& document) {
  const std::string take = "Timecode,BlendShapeCount,Jaw\n0:0:0:0,1,0\n0:0:0:1,1,0.5\n";
  auto track = penpose::io::read_track(penpose::base::as_bytes(take), nullptr, {});
  if (!track) return false;
  const auto map = penpose::io::read_bundled_map(*track->format);
  const auto animated = penpose::animate(document, std::move(track->track), map.value());
  return animated && animated->document.model->animations.size() == 1 && animated->poses[1] != animated->poses[0];
}

int pose() {
  auto model = penpose::character::make_demo_head();
  if (!model) return fail(model.error().line());
  penpose::Character head(penpose::document::make_document(std::move(model).value()));
  const auto lip = head.place_reference(head.points_of("lip_upper").value());
  auto places = head.positions_of(lip.value()).value();
  for (auto& p : places) p.y += 0.002;
  if (const auto placed = head.place_target(*lip, places); !placed) return fail(placed.error().line());
  if (const auto solved = head.solve(); !solved) return fail(solved.error().line());
  const auto distances = head.distances_of(*lip).value();
  std::vector<penpose::Point> positions(head.vertex_count());
  head.evaluate(head.pose(), positions);
  if (!animates(head.document())) return fail("a track does not become an animation");
  std::printf("pose %.17g %.17g\n", *std::max_element(distances.begin(), distances.end()),
              positions[positions.size() / 2].x);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  int wrong_sign = argc;  // Compared below: nobody's error but this program's.
  unsigned long count = 0;
  for (; count + 1 < wrong_sign; ++count) {
    if (replay(argv[count + 1]) != 0) return 1;
  }
  return pose();
}
