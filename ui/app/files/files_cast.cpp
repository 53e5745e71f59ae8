#include <filesystem>
#include <utility>

#include "ui/app/files/files.h"
#include "ui/files/save_model.h"
#include "ui/files/sound/sound_file.h"

// What is done with the files of several characters.

namespace penpose::app {
namespace {

namespace fs = std::filesystem;

std::string path_of_character(const std::string& file, std::size_t number) {
  files::ModelName name{file, {}};
  name.character = number + 1;
  return name.text();
}

bool is_room_for(std::size_t count, const Cast& cast) { return cast.size() + count <= io::k_most_characters; }

}  // namespace

void Files::open_cast(files::LoadedCast loaded, const std::string& path, bool beside) {
  std::error_code code;
  const std::string full = fs::absolute(path, code).string();
  const std::size_t first = beside ? parts_.cast.size() : 0;
  for (std::size_t i = 0; i < loaded.documents.size(); ++i) {
    if (beside || i > 0) parts_.cast.set_aside();
    begin_session(std::move(loaded.documents[i]), path_of_character(full, i),
                  {beside || i > 0, &loaded.cast.members[i]});
    if (!beside && i == 0) parts_.cast.describe(0, loaded.cast.members[0]);
  }
  if (!beside) parts_.cast.mark_saved();
  work_on(first + loaded.cast.active);
  if (!beside) {
    parts_.cast.mark_saved();
    take_first_tool();
    parts_.cast.frame_active();
  }
  set_project(project_);
}

base::Status Files::add(const std::string& path) {
  if (parts_.editing.pen_is_drawing()) return base::Error{"a line is being drawn", "", "lift the pen"};
  if (path.starts_with("tour:") || path.ends_with(".session"))
    return base::Error{"is no character", "", "add a model or a project"};
  auto several = files::load_cast(path, files::NamedBy::file);
  if (!several) return several.error();
  const base::Error full{"there are " + std::to_string(parts_.cast.size()) + " characters, as many as a project has",
                         "", "take one away first"};
  if (*several) {
    if (!is_room_for((*several)->documents.size(), parts_.cast)) return full;
    open_cast(std::move(**several), path, true);
    return base::Done{};
  }
  if (!is_room_for(1, parts_.cast)) return full;
  auto document = files::load_document(path, files::NamedBy::file);
  if (!document) return document.error();
  const drawing::Tool tool = parts_.editing.editor().tool();
  parts_.cast.set_aside();
  begin_session(std::move(*document), path, {true, nullptr});
  parts_.editing.set_tool(tool);
  parts_.cast.place_beside(parts_.cast.active());
  parts_.cast.frame_all();
  parts_.features.begin(!path.starts_with("builtin:"));
  if (!path.starts_with("builtin:")) parts_.preferences.remember(path_);
  parts_.notices.tell(parts_.cast.at(parts_.cast.active()).name + " stands beside the others and is worked on now");
  return base::Done{};
}

void Files::work_on(std::size_t character) {
  Cast& cast = parts_.cast;
  if (character >= cast.size() || character == cast.active() || parts_.editing.pen_is_drawing()) return;
  parts_.performer.drop();
  parts_.player.trace.reset();
  const drawing::Tool tool = parts_.editing.editor().tool();
  cast.set_aside();
  cast.take_up(character);
  path_ = cast.at(character).path;
  parts_.editing.set_tool(tool);
  parts_.switched();
}

void Files::remove(std::size_t character) {
  Cast& cast = parts_.cast;
  if (!cast.several() || character >= cast.size() || parts_.editing.pen_is_drawing()) return;
  if (character == cast.active()) work_on(character == 0 ? 1 : character - 1);
  const std::string name = cast.at(character).name;
  cast.remove(character);
  parts_.notices.tell(name + " is taken away: Bring back the character brings it back");
}

base::Status Files::save_all(const std::string& path) {
  std::error_code code;
  const std::string full = fs::absolute(path, code).string();
  Cast& cast = parts_.cast;
  for (std::size_t i = 0; i < cast.size(); ++i) {
    const std::string opened = files::model_name(cast.at(i).path).file;
    if (full != opened && !fs::equivalent(full, opened, code)) continue;
    SessionFile* file = cast.aside(i).recorded.file.get();
    const auto kept = i == cast.active() ? parts_.recording.keep_model(opened)
                      : file != nullptr  ? file->keep_model(opened)
                                         : base::Status(base::Done{});
    if (!kept) {
      return base::Error{"is not saved: the model that the session of " + cast.at(i).name +
                             " began on cannot be kept beside it, " + kept.error().what,
                         "", "save under another name, or make room"};
    }
  }
  for (std::size_t i = 0; i < cast.size(); ++i) {
    const auto sound = renamed_sound(cast.document(i), cast.at(i).path, path);
    if (!sound) continue;
    if (i == cast.active()) {
      parts_.editing.perform_with(*sound);
    } else {
      (void)parts_.editing.act_aside(cast.aside(i).session, replay::Performed{*sound});
    }
  }
  if (auto saved = files::save_cast(cast.described(), cast.documents(), path); !saved) return saved;
  parts_.editing.mark_saved();
  cast.mark_saved();
  set_project(full);
  parts_.preferences.remember(full);
  parts_.notices.tell("saved " + full + " with its " + std::to_string(cast.size()) + " characters");
  return base::Done{};
}

base::Status Files::export_each(const std::string& path) {
  const fs::path chosen(path);
  const Cast& cast = parts_.cast;
  for (std::size_t i = 0; i < cast.size(); ++i) {
    std::string name = cast.at(i).name;
    for (char& c : name) c = c == '/' ? '_' : c;
    const std::string file =
        (chosen.parent_path() / (chosen.stem().string() + "-" + name + chosen.extension().string())).string();
    if (auto written = files::save_document(cast.document(i), file, files::SaveNotes::quiet); !written) {
      return base::Error{written.error().line(file), "", ""};
    }
  }
  parts_.notices.tell("exported " + std::to_string(cast.size()) + " characters as " + chosen.stem().string() + "-...");
  return base::Done{};
}

base::Status Files::bring_back_member(const io::CastMember& member, const Joins& joins) {
  auto played = member.session.empty() ? base::Result<replay::ReplayResult>(base::Error{"is not recorded", "", ""})
                                       : played_session(member.session);
  if (played && !played->divergence) {
    if (auto file = SessionFile::resume(member.session, parts_.program)) {
      if (joins.beside) parts_.cast.set_aside();
      resume(std::move(*played), std::move(*file), joins);
      return base::Done{};
    }
  }
  // Nothing was done in a session that is not there.
  auto document = files::load_document(member.model, files::NamedBy::file);
  if (!document) return document.error();
  if (joins.beside) parts_.cast.set_aside();
  begin_session(std::move(*document), member.model, joins);
  return base::Done{};
}

base::Status Files::bring_back_cast(const io::Cast& cast) {
  bool any = false;
  std::size_t active = 0;
  for (std::size_t i = 0; i < cast.members.size(); ++i) {
    const io::CastMember& member = cast.members[i];
    if (const auto back = bring_back_member(member, {any, &member}); !back) {
      parts_.notices.tell(member.name + " does not come back: " + back.error().line(member.model), true);
      continue;
    }
    if (!any) parts_.cast.describe(0, member);
    if (i == cast.active) active = parts_.cast.active();
    any = true;
  }
  if (!any) return base::Error{"none of the characters can be brought back", "", "open their sessions one by one"};
  work_on(active);
  parts_.cast.frame_active();
  // A character in whose session nothing was done yet does not know where all of them were saved.
  for (const io::CastMember& member : cast.members) {
    if (project_.empty() && !member.session.empty()) project_ = project_of_session(member.session);
    const std::string file = files::model_name(member.model).file;
    if (project_.empty() && cast.members.size() > 1 && files::is_project(file)) project_ = file;
  }
  return base::Done{};
}

}  // namespace penpose::app
