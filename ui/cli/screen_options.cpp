#include "ui/cli/screen_options.h"

#include <string>
#include <vector>

namespace penpose::cli {

void add_screen_options(const Command& app, files::WindowRequest& request) {
  app.add_option("--screen", request.screen, "Which of the connected screens, from 0").between(0, 31);
  app.add_option("--rotate", request.rotate,
                 "Turn the picture clockwise by 90, 180 or 270 degrees, for a panel that is mounted turned; the "
                 "processor draws")
      .one_of_numbers({0, 90, 180, 270});
  app.add_option("--rotate-input", request.rotate_input,
                 "Which pens and fingers are turned with the picture: fingers and pens of the machine itself "
                 "(built-in), pens by USB and Bluetooth, too (all), or none, where the system turns them")
      .one_of({"built-in", "all", "none"});
  app.add_option("--dpi", request.dpi, "Pixels per inch of the screen, where it says none or wrong ones")
      .between(60.0, 600.0);
  app.add_option("--scale", request.scale,
                 "Size of the interface, 1 being that of 96 pixels per inch; without it, as chosen with Larger and "
                 "Smaller on top of what the desktop says, or else the screen's pixels per inch")
      .between(0.5, 4.0);
  app.add_option(
         "--screen-kind", [&request](const std::string& kind) { request.slow_screen = kind == "slow"; },
         "slow: a screen that takes long to change (electronic paper): nothing moves by itself, and while the pen "
         "draws "
         "only its line does")
      .one_of({"usual", "slow"});
}

}  // namespace penpose::cli
