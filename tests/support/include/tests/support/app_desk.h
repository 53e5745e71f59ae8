#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <initializer_list>
#include <string>
#include <unistd.h>
#include <vector>

#include "core/geometry/camera.h"
#include "ui/app/app.h"
#include "ui/app/interface.h"

namespace penpose::app {

/// The app with its panels and no window, in a folder of its own, with a clock that goes by hand.
class Desk {
 public:
  explicit Desk(const std::string& name, const std::string& model = "builtin:demo", bool fresh = true,
                bool slow_screen = false)
      : folder(folder_of(name)) {
    if (fresh) std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    // Most of what is tried begins with a reference.
    if (fresh) {
      std::filesystem::create_directories(folder / "config");
      std::ofstream(folder / "config" / "settings") << "pose_first=1\n";
    }
    AppOptions options;
    options.folders = {(folder / "state").string(), (folder / "config").string(), (folder / "poses").string()};
    options.clock = [this] { return now_us; };
    options.slow_screen = slow_screen;
    options.date = [] { return std::string("2026-01-02_03-04-05"); };
    app = std::make_unique<App>(options);
    app->of<Dialogs>().state<FileChoice>().folder = folder.string();
    const auto opened = app->of<Files>().open(model);
    EXPECT_TRUE(opened.ok()) << (opened.ok() ? "" : opened.error().line());
    interface = std::make_unique<Interface>(*app);
    frames();
  }
  /// The desk's folder below one of the running test program, which goes with it.
  static std::filesystem::path folder_of(const std::string& name) {
    struct Root {
      std::filesystem::path path =
          std::filesystem::temp_directory_path() / ("penpose-desk-" + std::to_string(::getpid()));
      ~Root() {
        std::error_code code;
        std::filesystem::remove_all(path, code);
      }
    };
    static const Root root;
    return root.path / name;
  }
  ~Desk() {
    interface.reset();
    app.reset();
  }
  Desk(const Desk&) = delete;
  Desk& operator=(const Desk&) = delete;

  void frames(int count = 4) {
    for (int i = 0; i < count; ++i) {
      now_us += 16000;
      app->begin_frame();
      interface->frame(0.016);
    }
  }
  void begin() {
    if (interface->find("Begin") != nullptr) click("Begin");
  }
  bool click(const std::string& label) {
    const Area* area = interface->find(label);
    EXPECT_NE(area, nullptr) << "nothing on the screen says " << label;
    if (area == nullptr) return false;
    const PxPoint at = area->middle();
    app->of<Pointer>().moved(at);
    app->of<Pointer>().button(MouseButton::left, true, at);
    app->of<Pointer>().button(MouseButton::left, false, at);
    frames();
    return true;
  }
  /// Opens the menu and the section that has an entry.
  void open_menu(const std::string& section) {
    click("Menu");
    click(section + "##section");
  }
  /// Moves the pointer onto something, without a press.
  void hover(const std::string& label) {
    const Area* area = interface->find(label);
    ASSERT_NE(area, nullptr) << "nothing on the screen says " << label;
    app->of<Pointer>().moved(area->middle());
    frames();
  }
  /// Touches what is left of a row's name, while the pointer is on it and its buttons are shown.
  bool touch_row(const std::string& label) {
    hover(label);
    return click(label);
  }
  /// Locks a control in the list, or frees it, by its row's menu.
  void turn_lock(const std::string& name) {
    std::string row = "name " + name;
    if (interface->find(row) == nullptr) row.back() = 'L';
    ASSERT_TRUE(touch_row(row));
    for (const auto& [label, area] : interface->targets()) {
      if (!label.ends_with("##lock " + name) || label.find("both") != std::string::npos) continue;
      click(std::string(label));
      return;
    }
    FAIL() << "no menu locks " << name;
  }
  void press(std::uint32_t key, bool ctrl = false, bool shift = false) {
    app->of<Actions>().press({key, ctrl, shift});
    frames();
  }
  /// Keys of a keyboard, pressed and released before the next frame, with what they type.
  void type(const std::string& text) {
    for (const char c : text) {
      const std::string one(1, c);
      const int scancode = c >= 'a' && c <= 'z' ? 4 + (c - 'a') : c == ' ' ? 44 : 30;
      interface->key(scancode, {static_cast<std::uint32_t>(c), false, false}, true);
      interface->text(one.c_str());
      interface->key(scancode, {static_cast<std::uint32_t>(c), false, false}, false);
    }
    frames(3 * static_cast<int>(text.size()) + 4);
  }
  /// A key that types nothing, by its scancode and as actions name it.
  void hit(int scancode, std::uint32_t key = 0, bool ctrl = false, bool shift = false) {
    interface->key(scancode, {key, ctrl, shift}, true);
    interface->key(scancode, {key, ctrl, shift}, false);
    frames(6);
  }
  void hit_return() { hit(40); }
  void hit_escape() { hit(41, k_key_escape); }
  void hit_backspace() { hit(42); }
  /// A stroke of the mouse through px positions of the window, with small steps in between.
  void stroke(const std::vector<PxPoint>& through, bool lift = true) {
    app->of<Pointer>().moved(through.front());
    app->of<Pointer>().button(MouseButton::left, true, through.front());
    for (std::size_t i = 1; i < through.size(); ++i) {
      for (int k = 1; k <= 8; ++k) {
        now_us += 3000;
        app->of<Pointer>().moved(through[i - 1] * (1 - k / 8.0) + through[i] * (k / 8.0));
      }
      app->begin_frame();
    }
    if (lift) app->of<Pointer>().button(MouseButton::left, false, through.back());
    frames();
  }
  /// Pulls a slider by its label from one share of its width to another, and lets it go or not.
  void drag_slider(const std::string& label, double from, double to, bool lift = true) {
    const Area* slider = interface->find("slider " + label);
    ASSERT_NE(slider, nullptr) << label;
    const PxPoint middle = slider->middle();
    const double left = slider->left, width = slider->width();
    const auto at = [&](double share) { return PxPoint{left + share * width, middle.y}; };
    app->of<Pointer>().moved(at(from));
    app->of<Pointer>().button(MouseButton::left, true, at(from));
    frames();
    app->of<Pointer>().moved(at(to));
    frames();
    if (lift) let_go(at(to));
  }
  /// Pulls what a panel shows from one place to another, with frames in between as panels see them.
  void pull(PxPoint from, PxPoint to) {
    app->of<Pointer>().moved(from);
    frames();
    app->of<Pointer>().button(MouseButton::left, true, from);
    frames();
    app->of<Pointer>().moved(from * 0.5 + to * 0.5);
    frames();
    app->of<Pointer>().moved(to);
    frames();
    let_go(to);
  }
  void let_go(PxPoint at) {
    app->of<Pointer>().button(MouseButton::left, false, at);
    frames();
  }
  /// Opens a dialog; the number that it may ask for is the jaw's.
  void show(const Dialog& dialog) {
    app->of<Dialogs>().state<NumberEntry>().parameter = "jaw";
    app->of<Dialogs>().show(dialog);
    frames();
  }
  /// What is labelled so lies within a window of that size.
  void expect_within(int width, int height, std::initializer_list<const char*> labels) {
    for (const char* label : labels) {
      const Area* area = interface->find(label);
      ASSERT_NE(area, nullptr) << label;
      EXPECT_GE(area->left, 0) << label;
      EXPECT_LE(area->right, width) << label;
      EXPECT_LE(area->bottom, height) << label << width;
    }
  }
  /// Where the view shows points of a named curve of the model at rest, moved by some px.
  [[nodiscard]] std::vector<PxPoint> named_curve(const std::string& name, PxPoint by = {}) const {
    const document::View& view = app->of<Canvas>().view();
    const auto camera = geometry::Camera::make(view.camera, view.viewport);
    std::vector<PxPoint> line;
    for (const auto& curve : document().model->curves) {
      if (curve.name != name) continue;
      for (const auto& point : curve.points) {
        const auto px = camera->project(geometry::ModelPoint(app->of<Canvas>().surface().at(point)));
        if (px) line.push_back(*px + by);
      }
    }
    EXPECT_GT(line.size(), 1U) << "the model has no curve " << name;
    return line;
  }
  /// Parameters of the model, by name.
  [[nodiscard]] std::size_t index_of(const std::string& name) const {
    return *rig::find_parameter(document().model->rig->parameters(), name);
  }
  [[nodiscard]] double value_of(const std::string& name) const { return document().pose[index_of(name)]; }
  void set(const std::string& name, double value) {
    app->of<Controls>().set_parameter(index_of(name), value);
    frames(1);
  }
  /// Whether a notice has these words.
  [[nodiscard]] bool says(const std::string& words) const {
    const auto& notices = app->of<Notices>().all();
    return std::any_of(notices.begin(), notices.end(),
                       [&](const Notice& one) { return one.text.find(words) != std::string::npos; });
  }
  [[nodiscard]] const document::Document& document() const { return app->of<EditingSession>().document(); }
  [[nodiscard]] std::string path(const std::string& name) const { return (folder / name).string(); }

  std::int64_t now_us = 1'000'000;
  std::filesystem::path folder;
  std::unique_ptr<App> app;
  std::unique_ptr<Interface> interface;
};

/// A closed line around a place.
inline std::vector<PxPoint> around(PxPoint middle, double x, double y) {
  std::vector<PxPoint> line;
  for (int i = 0; i <= 24; ++i) {
    const double t = 2 * 3.14159265 * i / 24;
    line.push_back({middle.x + x * std::cos(t), middle.y + y * std::sin(t)});
  }
  return line;
}

/// The first curve of the model, wide enough for a stroke.
inline std::string any_curve(const Desk& desk) {
  for (const auto& curve : desk.document().model->curves) {
    if (curve.name.find("mouth") != std::string::npos || curve.name.find("lip") != std::string::npos) return curve.name;
  }
  return desk.document().model->curves.front().name;
}

/// Draws along the mouth and then where it should go.
inline void pose_mouth(Desk& desk) {
  const std::string curve = any_curve(desk);
  const auto reference = desk.named_curve(curve);
  const auto target = desk.named_curve(curve, {0, -14});
  desk.stroke(reference);
  desk.stroke(target);
}

/// Draws along the mouth and where it should go; the name of what moved most.
[[nodiscard]] inline std::string moved_with_mouth(Desk& desk) {
  pose_mouth(desk);
  const auto& movements = desk.app->of<EditingSession>().last_stroke().movements();
  EXPECT_FALSE(movements.empty());
  return movements.empty() ? std::string() : movements.front().name;
}

/// Sketches a control below the mouth.
inline void sketch_chin(Desk& desk) {
  desk.click("Rig");
  const auto mouth = desk.named_curve(any_curve(desk));
  const PxPoint middle = mouth[mouth.size() / 2] + PxPoint{0, 55};
  desk.stroke(around(middle, 60, 32));
  desk.stroke(around(middle, 28, 14));
  desk.stroke({middle + PxPoint{-26, 18}, middle + PxPoint{0, 26}, middle + PxPoint{26, 18}});
}

}  // namespace penpose::app
