#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "ui/app/panels.h"
#include "ui/app/widgets.h"

namespace penpose::app {
namespace {

namespace fs = std::filesystem;

constexpr float k_wide = 17;

bool opens(const fs::path& path) {
  constexpr std::array k_extensions{".glb", ".gltf", ".obj", ".ply", ".off", ".stl", ".session", ".hid", ".trace"};
  std::string extension = path.extension().string();
  for (char& c : extension) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return std::find(k_extensions.begin(), k_extensions.end(), extension) != k_extensions.end();
}

/// Folders first, then what can be opened, by name.
std::vector<fs::directory_entry> entries_of(const std::string& folder) {
  std::vector<fs::directory_entry> entries;
  std::error_code code;
  for (fs::directory_iterator it(folder, code), end; !code && it != end; it.increment(code)) {
    if (it->path().filename().string().starts_with('.')) continue;
    std::error_code ignored;
    if (it->is_directory(ignored) || opens(it->path())) entries.push_back(*it);
  }
  std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) {
    std::error_code ignored;
    const bool a_folder = a.is_directory(ignored);
    const bool b_folder = b.is_directory(ignored);
    return a_folder != b_folder ? a_folder : a.path().filename() < b.path().filename();
  });
  return entries;
}

/// The folder with its parent and what is in it. Gives the file that was chosen.
std::string browse(PanelContext& context, float height) {
  std::string& folder = context.app.panels().folder;
  std::string chosen;
  ImGui::TextUnformatted(folder.c_str());
  ImGui::BeginChild("files", {0, height}, true);
  if (wide_button(context, "..##parent", -1)) folder = fs::path(folder).parent_path().string();
  for (const auto& entry : entries_of(folder)) {
    std::error_code ignored;
    const bool is_folder = entry.is_directory(ignored);
    const std::string name = entry.path().filename().string() + (is_folder ? "/" : "");
    if (!wide_button(context, name.c_str(), -1)) continue;
    if (is_folder) {
      folder = entry.path().string();
      break;
    }
    chosen = entry.path().string();
  }
  ImGui::EndChild();
  return chosen;
}

void open_dialog(PanelContext& context) {
  App& app = context.app;
  if (begin_dialog(context, "Open", k_wide)) {
    std::string chosen;
    if (wide_button(context, "The built-in head with its controls", -1)) chosen = "builtin:demo";
    if (wide_button(context, "The built-in head alone, to sketch controls on", -1)) chosen = "builtin:head";
    const auto recent = app.settings().recent;
    constexpr std::size_t k_shown = 3;
    for (std::size_t i = 0; i < std::min(k_shown, recent.size()); ++i) {
      if (wide_button(context, recent[i].c_str(), -1, false, "Opened before")) chosen = recent[i];
    }
    if (const std::string file = browse(context, 7 * context.unit); !file.empty()) chosen = file;
    if (wide_button(context, "Cancel")) app.panels().dialog = Dialog::none;
    if (!chosen.empty()) {
      if (app.workspace().unsaved()) {
        app.panels().after_unsaved = chosen;
        app.panels().dialog = Dialog::unsaved;
      } else {
        app.try_open(chosen);
      }
    }
  }
  end_dialog();
}

void save_dialog(PanelContext& context) {
  App& app = context.app;
  PanelState& panels = app.panels();
  if (panels.file_name.empty()) {
    const std::string from = !app.project().empty() ? app.project() : app.path();
    const std::string stem = from.starts_with("builtin:") ? "head" : fs::path(from).stem().string();
    // A free name, so that Save alone is enough for whoever has no keyboard at hand.
    panels.file_name = app.project().empty() ? fs::path(free_path(panels.folder, stem, ".glb")).filename().string()
                                             : fs::path(app.project()).filename().string();
  }
  if (begin_dialog(context, "Save", k_wide)) {
    text_field(context, "##name", panels.file_name, -1, "name.glb");
    ImGui::TextDisabled(".glb keeps the whole project and plays in any viewer; .obj keeps the pose alone");
    if (const std::string file = browse(context, 6 * context.unit); !file.empty()) {
      panels.file_name = fs::path(file).filename().string();
    }
    if (wide_button(context, "Save##now", 4 * context.unit) && !panels.file_name.empty()) {
      const std::string path = (fs::path(panels.folder) / panels.file_name).string();
      if (const auto saved = app.save(path); !saved) {
        app.tell(saved.error().line(path), true);
      } else {
        panels.dialog = Dialog::none;
        panels.file_name.clear();
      }
    }
    ImGui::SameLine();
    if (wide_button(context, "Cancel")) {
      panels.dialog = Dialog::none;
      panels.file_name.clear();
    }
  }
  end_dialog();
}

void recover_dialog(PanelContext& context) {
  App& app = context.app;
  if (begin_dialog(context, "The program did not close as it should", 13)) {
    const std::string name = app.abandoned().empty() ? "" : fs::path(app.abandoned().front()).stem().string();
    ImGui::TextWrapped("What was drawn in the session %s is kept, to the last stroke.", name.c_str());
    if (wide_button(context, "Bring it back", 5 * context.unit)) {
      app.recover(true);
    } else {
      ImGui::SameLine();
      if (wide_button(context, "Start anew", 5 * context.unit, false, "The session stays in the list of sessions"))
        app.recover(false);
    }
  }
  end_dialog();
}

void steps_dialog(PanelContext& context) {
  App& app = context.app;
  if (begin_dialog(context, "Draw, and the face follows", 14)) {
    ImGui::TextWrapped("1   Draw along a feature as it is: the line of the mouth, a brow, an eyelid.");
    ImGui::Dummy({1, context.gap});
    ImGui::TextWrapped(
        "2   Draw where it should go. The face follows while you draw and settles when you lift the pen.");
    ImGui::Dummy({1, context.gap});
    ImGui::TextWrapped("3   Press Key to keep the pose on the timeline, and Save. Undo takes back anything.");
    ImGui::Dummy({1, context.gap});
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ImGui::TextWrapped(
        "Turn the view with the pen's button, the middle mouse button or two fingers. A click of the pen's button "
        "opens "
        "a menu around the pen.");
    ImGui::PopStyleColor();
    if (wide_button(context, "Begin", -1)) {
      app.panels().dialog = Dialog::none;
      app.settings().steps_seen = true;
      app.settings_changed();
    }
  }
  end_dialog();
}

void tablet_dialog(PanelContext& context) {
  App& app = context.app;
  replay::TabletSetting& setting = app.settings().tablet;
  if (begin_dialog(context, "Tablet", k_wide)) {
    bool changed = false;
    const auto flag = [&](const char* label, bool& on, const char* tip) {
      if (wide_button(context, label, -1, on, tip)) {
        on = !on;
        changed = true;
      }
    };
    flag("Keep the picture's shape", setting.keep_aspect,
         "Uses only as much of the tablet as has the shape of the window");
    flag("Left-handed", setting.left_handed, "The tablet lies turned by half a turn");
    // Four slices of the area and the softness of the pressure, each by sliders alone.
    std::array<double, 4> area{0, 0, 1, 1};
    if (setting.area.size() == 4) std::copy(setting.area.begin(), setting.area.end(), area.begin());
    constexpr std::array k_sides{"left", "top", "right", "bottom"};
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {8, 0.5F * (context.unit - ImGui::GetFontSize())});
    for (std::size_t i = 0; i < 4; ++i) {
      const double least = i < 2 ? 0 : area[i - 2] + 0.05;
      const double most = i < 2 ? area[i + 2] - 0.05 : 1;
      ImGui::SetNextItemWidth(-3 * context.unit);
      if (ImGui::SliderScalar(k_sides[i], ImGuiDataType_Double, &area[i], &least, &most, "%.2f",
                              ImGuiSliderFlags_NoInput)) {
        setting.area.assign(area.begin(), area.end());
        changed = true;
      }
      note(context, k_sides[i]);
    }
    // One point in the middle bends the curve: pressed half as hard means this much.
    double half = setting.pressure.size() == 3 ? setting.pressure[1].y : 0.5;
    const double least = 0.05;
    const double most = 0.95;
    ImGui::SetNextItemWidth(-3 * context.unit);
    if (ImGui::SliderScalar("softness", ImGuiDataType_Double, &half, &least, &most, "half pressed means %.2f",
                            ImGuiSliderFlags_NoInput)) {
      setting.pressure = {{0, 0}, {0.5, half}, {1, 1}};
      changed = true;
    }
    note(context, "softness");
    ImGui::PopStyleVar();
    if (changed) app.tablet_setting_changed();
    ImGui::TextDisabled("Draw here to try it");
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const ImVec2 size{ImGui::GetContentRegionAvail().x, 5 * context.unit};
    ImGui::InvisibleButton("try", size);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(from, {from.x + size.x, from.y + size.y}, ImGui::GetColorU32(ImGuiCol_FrameBg), 4);
    // The whole window's area, seen small.
    const auto window = app.window();
    const auto& line = app.panels().test_line;
    for (std::size_t i = 1; i < line.size(); ++i) {
      const auto place = [&](PxPoint p) {
        return ImVec2{from.x + static_cast<float>(p.x / window.width) * size.x,
                      from.y + static_cast<float>(p.y / window.height) * size.y};
      };
      list.AddLine(place(line[i - 1]), place(line[i]), ImGui::GetColorU32(ImGuiCol_PlotLines),
                   1 + 6 * static_cast<float>(app.panels().test_pressure[i]));
    }
    if (wide_button(context, "As it was##tablet")) {
      setting = {};
      app.tablet_setting_changed();
    }
    ImGui::SameLine();
    if (wide_button(context, "Done")) app.panels().dialog = Dialog::none;
  }
  end_dialog();
}

void sessions_dialog(PanelContext& context) {
  App& app = context.app;
  if (begin_dialog(context, "Sessions", k_wide)) {
    const std::string now = app.session_path();
    ImGui::TextWrapped("Everything that is drawn is recorded. This session: %s",
                       now.empty() ? "not recorded" : now.c_str());
    ImGui::BeginChild("sessions", {0, 8 * context.unit}, true);
    for (const std::string& path : past_sessions(app.options().folders.state + "/sessions")) {
      if (path == now) continue;
      ImGui::PushID(path.c_str());
      if (wide_button(context, "Play##session", 2.4F * context.unit, false, "Watch it in this window")) {
        if (const auto played = app.play_trace(path); !played) app.tell(played.error().line(path), true);
      }
      ImGui::SameLine();
      if (wide_button(context, "Go on##session", 2.4F * context.unit, false, "Open where it ended")) app.try_open(path);
      ImGui::SameLine();
      text_beside(context, fs::path(path).stem().string().c_str());
      ImGui::PopID();
    }
    ImGui::EndChild();
    if (wide_button(context, "Close")) app.panels().dialog = Dialog::none;
  }
  end_dialog();
}

void unsaved_dialog(PanelContext& context) {
  App& app = context.app;
  if (begin_dialog(context, "There is unsaved work", 13)) {
    ImGui::TextWrapped("It is kept in the list of sessions in any case.");
    const std::string next = app.panels().after_unsaved;
    if (wide_button(context, "Save first")) app.panels().dialog = Dialog::save;
    ImGui::SameLine();
    if (wide_button(context, "Go on without saving")) {
      app.panels().dialog = Dialog::none;
      if (next.empty()) {
        app.quit();
      } else {
        app.try_open(next);
      }
    }
    ImGui::SameLine();
    if (wide_button(context, "Cancel")) app.panels().dialog = Dialog::none;
  }
  end_dialog();
}

}  // namespace

void show_dialog(PanelContext& context) {
  switch (context.app.panels().dialog) {
    case Dialog::none:
      break;
    case Dialog::open:
      open_dialog(context);
      break;
    case Dialog::save:
      save_dialog(context);
      break;
    case Dialog::recover:
      recover_dialog(context);
      break;
    case Dialog::steps:
      steps_dialog(context);
      break;
    case Dialog::tablet:
      tablet_dialog(context);
      break;
    case Dialog::sessions:
      sessions_dialog(context);
      break;
    case Dialog::unsaved:
      unsaved_dialog(context);
      break;
  }
}

}  // namespace penpose::app
