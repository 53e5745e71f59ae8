#include "ui/cli/draw_option.h"

#include <CLI/CLI.hpp>
#include <map>
#include <string>

namespace penpose::cli {

void add_draw_option(CLI::App& command, std::optional<render::DrawWay>& way) {
  static const std::map<std::string, render::DrawWay> ways{
      {"gl", render::DrawWay::gl}, {"es", render::DrawWay::es}, {"cpu", render::DrawWay::cpu}};
  command
      .add_option_function<std::string>(
          "--draw", [&way](const std::string& name) { way = ways.at(name); },
          "how it is drawn: gl (OpenGL 3.1 or ES 3.0), es (OpenGL ES 2.0 or OpenGL 2.1), cpu (the processor, the same "
          "bits on every machine); default: the first that starts")
      ->check(CLI::IsMember(std::vector<std::string>{"gl", "es", "cpu"}));
}

}  // namespace penpose::cli
