// Allocations and calls for files fail while somebody draws in the app, poses, keys and saves: the app goes on, or ends
// with one line; what was saved before is whole, and the session replays as far as it goes.

#include <algorithm>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sys/wait.h>

#include "tests/support/app_desk.h"
#include "tests/ui/fault/fault_run.h"
#include "tests/ui/fault/faults.h"
#include "ui/files/files.h"

namespace penpose::app {
namespace {

using tests::FaultPlan;

constexpr std::size_t k_usual_runs = 40;  // spread over all calls

class AppFaults : public tests::FaultRun {
 protected:
  void SetUp() override {
    CommandRun::SetUp();
    save_face({"v 0 0.3 0", "v 2 0.3 0.2"});
  }

  /// What somebody does in a few minutes, with the plan from the first stroke on. Gives whether it could be saved.
  [[nodiscard]] bool use(const FaultPlan& plan) const {
    Desk desk("fault", path("face.glb"));
    desk.begin();
    tests::begin_faults(plan);
    const auto at = [&](double x, double y) {
      const document::View& view = desk.app->of<Canvas>().view();
      return *geometry::Camera::make(view.camera, view.viewport)->project({x, y, 0});
    };
    desk.stroke({at(0.1, 0.2), at(1, 0.2), at(1.9, 0.2)});
    desk.stroke({at(0.1, 0.45), at(1, 0.2), at(1.9, 0.45)});
    desk.app->of<Actions>().run(Action::key_pose);
    desk.app->of<Playback>().scrub(1);
    desk.app->of<Playback>().end_scrub();
    desk.app->of<Actions>().run(Action::reset_pose);
    desk.app->of<Actions>().run(Action::key_pose);
    desk.app->of<Actions>().run(Action::undo);
    const bool saved = desk.app->of<Files>().save(path("work.glb")).ok();
    desk.app->of<Actions>().run(Action::theme);
    desk.frames();
    return saved;
  }

  /// In a process of its own. Its exit status: 0 it went on to the end, 1 it ended, 2 it went on and could not save.
  [[nodiscard]] int use_with(const FaultPlan& plan, std::size_t* calls = nullptr) {
    const std::string log = path("log");
    const pid_t child = ::fork();
    if (child == 0) {
      const int errors = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
      ::dup2(errors, STDERR_FILENO);
      cli::end_where_memory_ends();
      int status = 1;
      try {
        status = use(plan) ? 0 : 2;
      } catch (const std::bad_alloc&) {
        status = 1;
      }
      const std::size_t counted = tests::end_faults();
      std::ofstream(path("calls")) << counted;
      ::_exit(testing::Test::HasFailure() ? 3 : status);
    }
    desk_ = std::filesystem::temp_directory_path() / ("penpose-desk-" + std::to_string(child));
    int ended = 0;
    ::waitpid(child, &ended, 0);
    if (calls != nullptr) *calls = std::strtoul(content("calls").c_str(), nullptr, 10);
    return WIFEXITED(ended) ? WEXITSTATUS(ended) : -WTERMSIG(ended);
  }

  /// Uses the app with one call failing, and holds it to what it promises. `whole`: what is saved when nothing fails.
  void run_with(const FaultPlan& plan, const std::string& whole) {
    const std::string what = (plan.kind == FaultPlan::Kind::memory ? "memory, call " : "files, call ") +
                             std::to_string(plan.number) + (plan.stays ? " and all after" : "");
    save("work.glb", std::string("as it was"));
    const int status = use_with(plan);
    const std::string said = content("log");
    if (plan.kind == FaultPlan::Kind::memory) {
      ASSERT_TRUE(status == 0 || status == 1) << what << ": " << status << " " << said;
      const bool one_line = said.starts_with("penpose: ") && std::count(said.begin(), said.end(), '\n') == 1;
      ASSERT_TRUE(status == 0 || one_line) << what << ": " << said;
    } else {
      ASSERT_TRUE(status == 0 || status == 2) << what << ": " << status << " " << said;
    }
    const std::string now = content("work.glb");
    ASSERT_TRUE(now == (status == 0 ? whole : "as it was") || (status != 0 && now == whole))
        << what << ": " << now.size() << " bytes, status " << status;
    ASSERT_NO_FATAL_FAILURE(check_files(what, status, plan.stays));
    std::filesystem::remove_all(desk_);
  }

  /// What was recorded replays to the states that were recorded, however early it ends; nothing half written is left.
  void check_files(const std::string& what, int status, bool stays) {
    std::error_code none;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(desk_, none)) {
      const std::string name = entry.path().filename().string();
      EXPECT_TRUE(status == 1 || name.find(".part") == std::string::npos) << what << ": " << entry.path();
      if (entry.path().extension() != ".session" || entry.file_size() == 0) continue;
      const int replayed = run({"replay", entry.path().string(), "--json"});
      const bool same = out_.find("\"differing\":0") != std::string::npos;
      ASSERT_TRUE(replayed != 0 || same) << what << ": " << out_;
      // What went on to its end is all there, unless the disk stayed full.
      if (status != 1 && !stays) {
        ASSERT_EQ(replayed, 0) << what << ": " << error_;
        ASSERT_EQ(field_of(out_, "steps"), field_of(whole_session_, "steps")) << what << ": " << out_;
        ASSERT_EQ(field_of(out_, "checked"), field_of(whole_session_, "checked")) << what << ": " << out_;
      }
    }
  }

  void every_call_fails(FaultPlan::Kind kind) {
    std::size_t calls = 0;
    ASSERT_EQ(use_with({kind, 0, false}, &calls), 0) << content("log");
    const std::string whole = content("work.glb");
    ASSERT_GT(whole.size(), 100U);
    ASSERT_GT(calls, 0U);
    whole_session_.clear();
    for (const auto& entry : std::filesystem::recursive_directory_iterator(desk_)) {
      if (entry.path().extension() != ".session") continue;
      ASSERT_EQ(run({"replay", entry.path().string(), "--json"}), 0) << error_;
      whole_session_ = out_;
    }
    ASSERT_NE(field_of(whole_session_, "steps"), "");
    std::filesystem::remove_all(desk_);
    const char* wanted = std::getenv("PENPOSE_FAULTS");
    const std::size_t step = wanted != nullptr && std::string(wanted) == "all" ? 1 : calls / k_usual_runs + 1;
    for (std::size_t n = 1; n <= calls; n += step) {
      for (const bool stays : {false, true}) ASSERT_NO_FATAL_FAILURE(run_with({kind, n, stays}, whole));
    }
  }
  /// A number of an object of JSON; empty: it has none of that name.
  [[nodiscard]] static std::string field_of(const std::string& json, const std::string& name) {
    const std::size_t at = json.find("\"" + name + "\":");
    if (at == std::string::npos) return {};
    const std::size_t from = at + name.size() + 3;
    return json.substr(from, json.find_first_of(",}", from) - from);
  }

  std::filesystem::path desk_;
  std::string whole_session_;
};

TEST_F(AppFaults, MemoryThatIsNotThereIsOneLineAndLosesNothing) { every_call_fails(FaultPlan::Kind::memory); }
TEST_F(AppFaults, FilesThatFailAreSaidAndLoseNothing) { every_call_fails(FaultPlan::Kind::files); }

}  // namespace
}  // namespace penpose::app
