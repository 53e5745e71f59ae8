#include "ui/app/files/drop_desk.h"

#include <algorithm>
#include <filesystem>
#include <utility>
#include <vector>

#include "core/base/json/json.h"
#include "core/document/commands/apply.h"
#include "ui/files/load_model.h"
#include "ui/files/save_model.h"

namespace penpose::app {
namespace {

/// The card of what was dropped.
constexpr Dialog k_drop_dialog{"drop"};

std::string short_name(const std::string& path) { return std::filesystem::path(path).filename().string(); }

/// A command holds no more values.
constexpr std::size_t k_most_values = 100000;

/// The keys of a take as commands that give them to a document: of the controls that it moves, one command where there
/// is room in it.
std::vector<document::KeyPoses> keys_of(const document::Document& taken) {
  const auto& keys = taken.timeline->keys;
  const auto parameters = taken.model->rig->parameters();
  std::vector<std::size_t> moved;
  document::KeyPoses empty;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto moves = [&](const auto& key) { return key.controls.has(i) && key.pose[i] != parameters[i].rest; };
    if (std::none_of(keys.begin(), keys.end(), moves)) continue;
    moved.push_back(i);
    empty.names.push_back(parameters[i].name);
  }
  std::vector<document::KeyPoses> commands;
  if (moved.empty()) return commands;
  for (const auto& key : keys) {
    if (commands.empty() || commands.back().values.size() + moved.size() > k_most_values) commands.push_back(empty);
    commands.back().times_s.push_back(key.time_s);
    for (const std::size_t i : moved) commands.back().values.push_back(key.pose[i]);
  }
  return commands;
}

}  // namespace

void DropDesk::drop(const std::string& path) {
  // Those that a dialog in between was shown over wait no longer.
  if (with_.dialogs.open() != k_drop_dialog) waiting_.clear();
  waiting_.push_back(path);
  if (waiting_.size() == 1) next();
}

void DropDesk::next() {
  if (waiting_.empty()) return with_.dialogs.close();
  kind_ = kind_of_dropped(waiting_.front());
  with_.dialogs.show(k_drop_dialog);
}

void DropDesk::cancel() {
  waiting_.clear();
  with_.dialogs.close();
}

void DropDesk::answer(DropDeed deed) {
  if (waiting_.empty()) return;
  const std::string path = std::move(waiting_.front());
  waiting_.pop_front();
  with_.dialogs.close();
  switch (deed) {
    case DropDeed::open:
      // What is open may have to be saved first: nothing else waits behind that.
      waiting_.clear();
      return with_.leaving.ask_to_open(path);
    case DropDeed::add_beside:
      if (const auto added = with_.files.add(path); !added) with_.notices.tell(added.error().line(path), true);
      break;
    case DropDeed::lay_sound:
      with_.sound.open(path);
      break;
    case DropDeed::reference_behind:
    case DropDeed::reference_beside:
      with_.references.open(path, deed == DropDeed::reference_beside);
      break;
    case DropDeed::read_drawing:
    case DropDeed::key_take:
      read(path, deed);
      break;
  }
  if (!waiting_.empty()) next();
}

void DropDesk::read(const std::string& path, DropDeed deed) {
  if (run_) return with_.notices.tell("another file is being read: drop it again afterwards", true);
  auto run = ProgramRun::prepare();
  if (!run) return with_.notices.tell(run.error().line(path), true);
  const std::string model = run->folder() + "/model.glb";
  if (const auto saved = files::save_document(with_.editing.document(), model, files::SaveNotes::quiet); !saved)
    return with_.notices.tell(saved.error().line(path), true);
  std::vector<std::string> words{with_.program};
  if (deed == DropDeed::read_drawing) {
    words.insert(words.end(), {"draw", model, path, "--json"});
  } else {
    words.insert(words.end(), {"animate", model, "--track", path, "-o", run->folder() + "/take.glb"});
  }
  if (const auto started = run->start(words); !started) return with_.notices.tell(started.error().line(path), true);
  run_ = std::make_unique<ProgramRun>(std::move(*run));
  reads_ = path;
  reads_as_ = deed;
  of_model_ = with_.editing.document().model;
  with_.notices.tell("reading " + short_name(path));
}

void DropDesk::take_drawing(const std::string& said) {
  const auto parsed = json::parse_json(base::as_bytes(said));
  const json::Json* poses = parsed ? json::find(*parsed, "parameters") : nullptr;
  if (poses == nullptr || !poses->is_object())
    return with_.notices.tell(short_name(reads_) + ": nothing was read of it", true);
  document::SetParameters command;
  const document::Document& document = with_.editing.document();
  const auto parameters = document.model->rig->parameters();
  for (const auto& [name, value] : poses->items()) {
    const auto number = rig::find_parameter(parameters, name);
    const auto wanted = json::number(value);
    if (number && wanted && document.pose[*number] != *wanted) command.values.push_back({name, *wanted});
  }
  if (command.values.empty())
    return with_.notices.tell(short_name(reads_) + ": no line of it moves this face; draw brows, lids and lips", true);
  if (with_.editing.perform(command))
    with_.notices.tell(short_name(reads_) + ": the face takes what the drawing shows; Key keeps it here");
}

void DropDesk::take_keys() {
  auto taken = files::load_document(run_->folder() + "/take.glb", files::NamedBy::file);
  if (!taken) return with_.notices.tell(taken.error().line(short_name(reads_)), true);
  document::ApplyWorkspace work;
  const auto opened = document::apply(*taken, document::OpenClip{0}, work);
  if (!opened) return with_.notices.tell(short_name(reads_) + ": " + opened.error().line(), true);
  const auto commands = keys_of(*opened);
  if (commands.empty())
    return with_.notices.tell(short_name(reads_) + ": nothing in it moves a control of this face", true);
  bool first = true;
  for (const document::KeyPoses& one : commands) {
    // One step of undo takes all of it back.
    if (first && !with_.editing.perform(one)) return;
    if (!std::exchange(first, false)) with_.editing.perform_with(one);
  }
  with_.playback.go_to(0);
  with_.notices.tell(short_name(reads_) + ": " + std::to_string(opened->timeline->keys.size()) + " keys of " +
                     std::to_string(commands.front().names.size()) + " controls");
}

void DropDesk::follow() {
  const auto ended = run_ ? run_->ended() : std::nullopt;
  if (!ended) return;
  if (!*ended) {
    with_.notices.tell(short_name(reads_) + ": " + ended->error().line(), true);
  } else if (of_model_ != with_.editing.document().model) {
    with_.notices.tell(short_name(reads_) + ": another model is open now; drop it again", true);
  } else if (reads_as_ == DropDeed::read_drawing) {
    take_drawing(run_->said());
  } else {
    take_keys();
  }
  run_.reset();
  reads_.clear();
}

}  // namespace penpose::app
