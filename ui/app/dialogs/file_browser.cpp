#include "ui/app/dialogs/file_browser.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include "ui/app/dialogs/file_rows.h"
#include "ui/app/widgets/button_row.h"
#include "ui/app/widgets/internal/icon.h"
#include "ui/app/widgets/internal/widgets.h"

// What dialogs of files have in common.

namespace penpose::app {
namespace {

namespace fs = std::filesystem;

/// From so many targets on the places stand beside the list.
constexpr float k_wide_enough = 17;
constexpr float k_places_wide = 5;
constexpr std::array k_sorts{"By name##sort", "By date##sort", "By size##sort"};

FileBrowser& state_of(const BrowsedWith& with) { return with.dialogs.state<FileBrowser>(); }
std::string& folder_of(const BrowsedWith& with) { return with.dialogs.state<FileChoice>().folder; }

void go_to(const BrowsedWith& with, const std::string& folder) {
  FileBrowser& state = state_of(with);
  folder_of(with) = folder;
  state.text.clear();
  state.chosen.reset();
  state.made.clear();
  state.places_shown = false;
}

void go_up(const BrowsedWith& with) { go_to(with, fs::path(folder_of(with)).parent_path().string()); }

/// Lists the folder where it is not that of before any more.
void list(const BrowsedWith& with, const BrowseLook& look) {
  FileBrowser& state = state_of(with);
  const TypedPath typed = typed_path(folder_of(with), look.has_field ? state.text : std::string(), home_folder());
  const Settings& settings = with.preferences.settings();
  FileView view{settings.file_sort, settings.hidden_files, look.kinds[state.kind].extensions, typed.name};
  std::error_code code;
  const auto changed = fs::last_write_time(typed.folder, code);
  if (state.folder == typed.folder && state.view == view && state.changed == changed && !code) return;
  if (state.folder != typed.folder || state.view != view) state.chosen.reset();
  state.folder = typed.folder;
  state.view = std::move(view);
  state.changed = changed;
  auto entries = list_folder(state.folder, state.view);
  state.error = entries ? std::string() : entries.error().line(state.folder);
  state.entries = entries ? std::move(*entries) : std::vector<FileEntry>();
}

template <typename Change>
void change_settings(const BrowsedWith& with, const Change& change) {
  change(with.preferences.settings());
  with.preferences.changed();
}

void show_tools(PanelContext& context, const BrowsedWith& with, const BrowseLook& look, bool wide) {
  FileBrowser& state = state_of(with);
  const Settings& settings = with.preferences.settings();
  ButtonRow row(context, "more of files");
  if (!wide) {
    ButtonRow::Button places{"Places##files", {}, "Home, volumes, and folders of before", true, state.places_shown};
    places.does = [&state] { state.places_shown = !state.places_shown; };
    row.add(std::move(places));
  }
  ButtonRow::Button up{"Up##files", {}, "The folder above (Backspace, where nothing is typed)"};
  up.does = [&with] { go_up(with); };
  row.add(std::move(up));
  ButtonRow::Button sort{k_sorts[static_cast<std::size_t>(settings.file_sort)], {}, "Press for another order"};
  sort.does = [&with] {
    change_settings(with, [](Settings& to) {
      to.file_sort = static_cast<FileSort>((static_cast<std::size_t>(to.file_sort) + 1) % k_sorts.size());
    });
  };
  row.add(std::move(sort));
  if (look.kinds.size() > 1) {
    ButtonRow::Button kind{std::string(look.kinds[state.kind].label) + "##kind", {}, "Press for another kind of files"};
    kind.does = [&state, count = look.kinds.size()] { state.kind = (state.kind + 1) % count; };
    row.add(std::move(kind));
  }
  ButtonRow::Button make{"New folder##files", {}, "Make a folder here", true, state.new_name.has_value()};
  make.does = [&state] {
    state.new_name = state.new_name ? std::nullopt : std::optional<std::string>("");
    state.new_begins = state.new_name.has_value();
    state.new_error.clear();
  };
  row.add(std::move(make));
  ButtonRow::Button hidden{"Hidden##files", {}, "Files whose names begin with a dot, too", true, settings.hidden_files};
  hidden.does = [&with] { change_settings(with, [](Settings& to) { to.hidden_files = !to.hidden_files; }); };
  row.add(std::move(hidden));
  row.show(ImGui::GetContentRegionAvail().x);
}

void make_new(const BrowsedWith& with) {
  FileBrowser& state = state_of(with);
  const auto made = make_folder(folder_of(with), *state.new_name);
  if (!made) {
    state.new_error = made.error().line();
    return;
  }
  go_to(with, *made);
  state.made = *made;
  state.new_name.reset();
  state.new_error.clear();
}

/// The name of a folder that is being made, and what came of it.
void show_new_folder(PanelContext& context, const BrowsedWith& with) {
  FileBrowser& state = state_of(with);
  if (state.new_name) {
    const bool returned = std::exchange(context.accepts, false);
    const float spacing = ImGui::GetStyle().ItemSpacing.x;
    const float wide = 3 * context.unit;
    if (std::exchange(state.new_begins, false)) ImGui::SetKeyboardFocusHere();
    text_field(context, "##new folder", *state.new_name, ImGui::GetContentRegionAvail().x - 2 * (wide + spacing),
               "the folder's name");
    ImGui::SameLine();
    const bool pressed = wide_button(context, "Make##new folder", wide);
    ImGui::SameLine();
    const bool leaves = wide_button(context, "Leave it##new folder", -1) || std::exchange(context.cancels, false);
    if (!state.new_error.empty()) ImGui::TextWrapped("%s", state.new_error.c_str());
    if (leaves) {
      state.new_name.reset();
    } else if (pressed || returned) {
      make_new(with);
    }
  } else if (!state.made.empty()) {
    text_beside(context, "The folder was made.");
    ImGui::SameLine();
    if (!wide_button(context, "Take it back##new folder")) return;
    std::error_code code;
    const std::string made = state.made;
    // One with something in it stays.
    if (fs::remove(made, code)) {
      go_to(with, fs::path(made).parent_path().string());
    } else {
      state.made.clear();
    }
  }
}

void show_places(PanelContext& context, const BrowsedWith& with, float width, float height) {
  begin_list(context, "places", {width, height}, true);
  for (const FilePlace& one : state_of(with).places) {
    const std::string label = one.label + "##place " + one.path;
    ButtonLook look{ImGui::GetContentRegionAvail().x, one.path == folder_of(with), one.path.c_str(), icon_of(one.kind)};
    look.left_aligned = true;
    if (icon_button(context, label.c_str(), look)) {
      go_to(with, one.path);
      break;
    }
  }
  ImGui::EndChild();
}

/// What was chosen: a folder is gone to, of a file the path is given.
std::string choose(const BrowsedWith& with, const FileEntry& entry) {
  const std::string path = (fs::path(state_of(with).folder) / entry.name).string();
  if (!entry.is_folder) return path;
  go_to(with, path);
  return {};
}

/// Up and down choose; Backspace goes to the folder above where nothing is typed. Whether another entry was chosen.
bool take_keys(const BrowsedWith& with, bool typed_nothing) {
  FileBrowser& state = state_of(with);
  const auto pressed = [](ImGuiKey_ key, bool repeats) {
    return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), repeats);
  };
  if (typed_nothing && pressed(ImGuiKey_Backspace, false)) go_up(with);
  if (state.entries.empty()) return false;
  const bool down = pressed(ImGuiKey_DownArrow, true);
  const bool up = pressed(ImGuiKey_UpArrow, true);
  if (!down && !up) return false;
  const std::size_t last = state.entries.size() - 1;
  if (!state.chosen) {
    state.chosen = down ? 0 : last;
  } else {
    state.chosen = std::min(last, down ? *state.chosen + 1 : *state.chosen - std::min<std::size_t>(1, *state.chosen));
  }
  return true;
}

/// What Return does with what is typed or chosen.
std::string accept(const BrowsedWith& with) {
  FileBrowser& state = state_of(with);
  if (state.chosen && *state.chosen < state.entries.size()) return choose(with, state.entries[*state.chosen]);
  if (state.text.empty()) return {};
  const TypedPath typed = typed_path(folder_of(with), state.text, home_folder());
  const std::string path = typed.name.empty() ? typed.folder : (fs::path(typed.folder) / typed.name).string();
  std::error_code code;
  if (fs::is_directory(path, code)) {
    go_to(with, path);
  } else if (fs::exists(path, code)) {
    return path;
  } else if (!state.entries.empty()) {
    return choose(with, state.entries.front());
  }
  return {};
}

}  // namespace

std::string browse(PanelContext& context, const BrowsedWith& with, const BrowseLook& look) {
  FileBrowser& state = state_of(with);
  if (context.dialog_opens) {
    state = {};
    state.places = places_here(with.files.project(), with.preferences.settings().recent);
  }
  state.kind = std::min(state.kind, look.kinds.size() - 1);
  const bool wide = ImGui::GetContentRegionAvail().x > k_wide_enough * context.unit;
  show_tools(context, with, look, wide);
  const std::string& typed = look.has_field ? state.text : with.dialogs.state<FileChoice>().name;
  // What erases the last letter goes nowhere else.
  const bool typed_nothing = std::exchange(state.was_empty, typed.empty()) && typed.empty() && !state.new_name;
  if (look.has_field) {
    const TextCompleter complete = [&](const std::string& text) {
      return completed_path(folder_of(with), text, home_folder(), {FileSort::name, false, state.view.extensions, {}});
    };
    dialog_field(context, "##path", state.text, "the beginning of a name, or a path", &complete);
  }
  list(with, look);
  const bool moved = !state.new_name && take_keys(with, typed_nothing);
  show_folder_line(context, state.error.empty() ? state.folder : state.error);
  show_new_folder(context, with);
  const float below = look.rows_below * (context.unit + ImGui::GetStyle().ItemSpacing.y);
  const float room = static_cast<float>(context.window.height) - 4 * context.gap - ImGui::GetCursorPosY() - below;
  const float height = std::clamp(room, 2 * context.unit, look.rows * context.unit);
  std::string chosen;
  if (wide || state.places_shown) show_places(context, with, wide ? k_places_wide * context.unit : 0, height);
  if (wide) ImGui::SameLine();
  if (wide || !state.places_shown) {
    begin_list(context, "files", {0, height}, true);
    const auto pressed = show_file_rows(context, state, moved);
    ImGui::EndChild();
    if (pressed) chosen = choose(with, *pressed);
  }
  if (!context.accepts || !(look.has_field || state.chosen)) return chosen;
  // In a dialog with a name of its own Return is for that, unless the arrows have chosen.
  context.accepts = false;
  return accept(with);
}

}  // namespace penpose::app
