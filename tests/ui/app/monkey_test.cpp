#include <cstdlib>
#include <gtest/gtest.h>
#include <random>

#include "tests/support/app_desk.h"

// No input makes the app fall over, whatever the order. The number of events is PENPOSE_MONKEY_EVENTS where that is
// set.

namespace penpose::app {
namespace {

class Monkey {
 public:
  Monkey(Desk& desk, unsigned seed) : desk_(desk), random_(seed) {}

  void act() {
    App& app = *desk_.app;
    switch (below(17)) {
      case 0:
      case 1:
      case 2:
      case 3:
        at_ = near_ ? at_ + PxPoint{spread(40), spread(40)} : anywhere();
        app.of<Pointer>().moved(at_);
        break;
      case 4:
      case 5:
        app.of<Pointer>().button(MouseButton::left, below(2) == 0, at_);
        break;
      case 6:
        app.of<Pointer>().button(below(2) == 0 ? MouseButton::middle : MouseButton::right, below(2) == 0, at_,
                                 below(3) == 0, below(3) == 0);
        break;
      case 7:
        app.of<Pointer>().wheel(spread(3));
        break;
      case 8:
        app.of<Pointer>().finger(static_cast<FingerKind>(below(3)), below(4), anywhere());
        break;
      case 9: {
        const auto actions = all_actions();
        const Action action = actions[static_cast<std::size_t>(below(static_cast<int>(actions.size())))].action;
        if (action != Action::quit) app.of<Actions>().run(action);
        break;
      }
      case 10:
        type_key();
        break;
      case 11:
        press_something();
        break;
      case 12:
        tablet();
        break;
      case 13:
        if (below(40) == 0) app.of<Pointer>().resized({64 + below(1500), 64 + below(1000)}, 40 + below(300));
        break;
      case 14:
        near_ = below(4) != 0;
        break;
      case 15: {
        const char text[2] = {static_cast<char>('a' + below(26)), 0};
        desk_.interface->text(text);
        break;
      }
      default:
        desk_.frames(1);
        // Nobody stays in a dialog for long.
        if (app.of<Dialogs>().any() && below(4) == 0) app.of<Actions>().run(Action::cancel);
        break;
    }
    desk_.now_us += below(20000);
    // Files are written below the test's own folder alone.
    if (app.of<Dialogs>().state<FileChoice>().folder.find(desk_.folder.string()) != 0)
      app.of<Dialogs>().state<FileChoice>().folder = desk_.folder.string();
    if (app.of<Dialogs>().state<FileChoice>().name.find('/') != std::string::npos)
      app.of<Dialogs>().state<FileChoice>().name.clear();
  }

 private:
  int below(int limit) { return static_cast<int>(random_() % static_cast<unsigned>(limit)); }
  double spread(double size) { return size * (static_cast<double>(random_() % 2001U) / 1000.0 - 1.0); }
  PxPoint anywhere() {
    const auto window = desk_.app->of<Canvas>().window();
    return {static_cast<double>(below(window.width + 40) - 20), static_cast<double>(below(window.height + 40) - 20)};
  }
  void type_key() {
    constexpr int k_return = 40;
    constexpr int k_escape = 41;
    KeyStroke stroke{static_cast<std::uint32_t>(below(200)), below(3) == 0, below(3) == 0};
    int scancode = below(120);
    if (below(4) == 0) {
      scancode = below(4) == 0 ? k_return : k_escape;
      stroke = {scancode == k_escape ? k_key_escape : 0, false, false};
    }
    // Nobody comes back from having quit.
    if (stroke.ctrl && stroke.key == 'q') return;
    desk_.interface->key(scancode, stroke, true);
    if (below(8) != 0) desk_.interface->key(scancode, stroke, false);
  }
  void press_something() {
    const auto& targets = desk_.interface->targets();
    if (targets.empty()) return;
    auto it = targets.begin();
    std::advance(it, below(static_cast<int>(targets.size())));
    at_ = it->second.middle();
    desk_.app->of<Pointer>().moved(at_);
    desk_.app->of<Pointer>().button(MouseButton::left, true, at_);
    desk_.frames(1 + below(3));
    desk_.app->of<Pointer>().button(MouseButton::left, false, at_);
    desk_.frames(1);
  }
  void tablet() {
    App& app = *desk_.app;
    const int device = 1 + below(2);
    if (below(12) == 0) {
      app.of<TabletEvents>().arrived(device, replay::virtual_pen_identity());
    } else if (below(12) == 0) {
      app.of<TabletEvents>().left(device, "a tablet");
    } else if (below(8) == 0) {
      std::vector<std::uint8_t> bytes(static_cast<std::size_t>(below(20)));
      for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random_());
      app.of<TabletEvents>().report(device, desk_.now_us, bytes);
    } else {
      pen_ = below(6) == 0 ? anywhere() : pen_ + PxPoint{spread(30), spread(30)};
      const replay::VirtualPenState state{pen_,          spread(0.5) + 0.5, below(12) != 0,
                                          below(3) != 0, below(30) == 0,    below(20) == 0};
      app.of<TabletEvents>().report(device, desk_.now_us, replay::virtual_pen_report(state, app.of<Canvas>().window()));
    }
  }

  Desk& desk_;
  std::mt19937 random_;
  PxPoint at_{500, 400};
  PxPoint pen_{500, 400};
  bool near_ = true;
};

TEST(Monkey, NoOrderOfEventsMakesTheAppFallOver) {
  const char* wanted = std::getenv("PENPOSE_MONKEY_EVENTS");
  const int events = wanted != nullptr ? std::atoi(wanted) : 5000;
  const char* seed = std::getenv("PENPOSE_MONKEY_SEED");
  Desk desk("monkey");
  desk.begin();
  // Films that it asks for are not written.
  desk.app->of<FilmWriter>().use_program("/bin/false");
  Monkey monkey(desk, seed != nullptr ? static_cast<unsigned>(std::atoi(seed)) : 2U);
  for (int i = 0; i < events; ++i) monkey.act();
  EXPECT_GT(desk.app->of<EditingSession>().revision(), static_cast<std::uint64_t>(events) / 100) << "it did something";
  // Afterwards it still works: a dialog closes, a view is framed, what was done is undone.
  for (const int device : {1, 2}) desk.app->of<TabletEvents>().left(device, "a tablet");
  desk.now_us += 10'000'000;
  desk.app->of<Pointer>().button(MouseButton::left, false, {0, 0});
  desk.app->of<Pointer>().button(MouseButton::right, false, {0, 0});
  desk.app->of<Dialogs>().show(Dialog::none);
  desk.app->of<PanelState>().radial.reset();
  // A tour takes back what it did not ask for, and a picture in hand has the canvas.
  desk.app->of<TourGuide>().leave();
  desk.app->of<CanvasLook>().backdrop.reset();
  desk.app->of<Pointer>().resized({1280, 800}, 96);
  desk.frames(6);
  while (desk.app->of<EditingSession>().steps().can_undo() > 0) desk.app->of<Actions>().run(Action::undo);
  desk.app->of<Actions>().run(Action::tool_pose);
  desk.app->of<Actions>().run(Action::view_front);
  desk.app->of<Actions>().run(Action::frame_all);
  desk.frames(6);
  const std::size_t curves = desk.document().curves.size();
  if (desk.document().model->curves.empty()) return;
  desk.stroke(desk.named_curve(desk.document().model->curves.front().name));
  EXPECT_EQ(desk.document().curves.size(), curves + 1);
}

}  // namespace
}  // namespace penpose::app
