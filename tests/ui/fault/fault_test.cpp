// Allocations and calls for files fail, in commands that read and write models, cases, tracks, pictures and sessions:
// each ends with one line that says so, and leaves the files that were there whole.

#include <cstdlib>
#include <fcntl.h>
#include <sys/wait.h>

#include "tests/ui/fault/fault_run.h"
#include "tests/ui/fault/faults.h"
#include "ui/files/files.h"

namespace penpose::tests {
namespace {

using Command = std::vector<std::string>;

constexpr std::size_t k_usual_runs = 150;  // of a command, spread over all of its calls

class Faults : public FaultRun {
 protected:
  void SetUp() override {
    CommandRun::SetUp();
    save_face({"v 0 0 0.5", "v 2 0 0.2"});
    save("cases.json",
         std::string(R"({"cases":[{"name":"a","references":[{"vertices":[0,1],"target":[[0,0,0.2],[1,0,0]]}]}]})"));
    save("track.json",
         std::string(R"({"fps":25,"frames":[{"curves":{"a":[[0,0],[90,9]]}},{"curves":{"a":[[0,3],[90,9]]}}]})"));
    save("map.json", std::string(R"({"format":"curves","curves":[{"track":"a","reference":[0,1]}]})"));
    save("pen.hid", std::string("D: 0\nN: pen\nI: 3 056a 0061\nE: 000000.0 1 00\n"));
    save("labels.json", std::string(R"({"frames":[{"image":"a.pgm","curves":{"a":[[1,1],[6,2]]}},)"
                                    R"({"image":"b.pgm","curves":{"a":[[1,2],[6,3]]}}]})"));
    for (const char* name : {"a.pgm", "b.pgm"}) {
      std::string picture = "P5\n8 8\n255\n";
      for (int i = 0; i < 64; ++i) picture += static_cast<char>('0' + (i * (name[0] == 'a' ? 7 : 11)) % 60);
      save(name, picture);
    }
  }

  std::vector<Command> commands() const {
    return {
        {"info", path("face.glb")},
        {"info", path("face.glb"), "--json"},
        {"convert", path("face.glb"), path("out.glb")},
        {"convert", path("face.glb"), path("out.obj")},
        {"convert", path("face.obj"), "--shapes", path("smile.obj"), path("out.glb")},
        {"pose", path("face.glb"), "--cases", path("cases.json"), "-o", path("out.glb")},
        {"animate", path("face.glb"), "--track", path("track.json"), "--map", path("map.json"), "-o", path("out.glb")},
        {"track", path("a.pgm"), path("b.pgm"), "--labels", path("labels.json"), "-o", path("out.json")},
        {"decode", path("pen.hid")},
        {"decode", path("pen.hid"), "--json"},
        {"replay", path("pen.hid"), "--model", path("face.glb"), "-o", path("out.glb")}};
  }

  void put_old_files() const {
    for (const char* name : {"out.glb", "out.obj", "out.json"}) save(name, std::string("as it was"));
  }

  /// Runs a command with one call failing, and holds it to what the program promises.
  void run_with(const Command& command, const FaultPlan& plan, const std::string& whole) {
    put_old_files();
    const std::string what =
        command[0] + ", call " + std::to_string(plan.number) + (plan.stays ? " and all after" : "");
    std::vector<const char*> argv{"penpose"};
    for (const auto& argument : command) argv.push_back(argument.c_str());
    // In a process of its own, which memory that is missing ends.
    const std::string log = path("log");
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      const int errors = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
      const int nothing = ::open("/dev/null", O_WRONLY);
      ::dup2(nothing, STDOUT_FILENO);
      ::dup2(errors, STDERR_FILENO);
      cli::end_where_memory_ends();
      begin_faults(plan);
      const int status = cli::run(static_cast<int>(argv.size()), argv.data());
      end_faults();
      ::_exit(status);
    }
    int ended = 0;
    ::waitpid(child, &ended, 0);
    ASSERT_TRUE(WIFEXITED(ended)) << what << ": signal " << WTERMSIG(ended);
    const int status = WEXITSTATUS(ended);
    const std::string said = content("log");
    ASSERT_TRUE(status == 0 || status == 1) << what << ": " << status;
    for (const char* name : {"out.glb", "out.obj", "out.json"}) {
      const std::string now = content(name);
      const bool is_output = command.back() == path(name);
      ASSERT_TRUE(now == "as it was" || (is_output && now == whole))
          << what << ": " << name << " has " << now.size() << " bytes";
    }
    if (status == 1) {
      const std::string last = said.substr(said.rfind("penpose: ") == std::string::npos ? 0 : said.rfind("penpose: "));
      ASSERT_TRUE(last.starts_with("penpose: ") && last.ends_with("\n") && last.size() < 500) << what << ": " << said;
    }
  }

  void every_call_fails_once(FaultPlan::Kind kind) {
    std::size_t runs = 0;
    for (const Command& command : commands()) {
      put_old_files();
      ASSERT_EQ(run(command), 0) << command[0] << ": " << error_;  // what is made once in a program is made now
      const std::string whole =
          std::filesystem::exists(command.back()) ? content(std::filesystem::path(command.back()).filename()) : "";
      begin_faults({kind, 0, false});
      ASSERT_EQ(run(command), 0);
      const std::size_t calls = end_faults();
      ASSERT_GT(calls, 0U) << command[0];
      // All of them take a quarter of an hour; PENPOSE_FAULTS=all runs them, and a number that one alone.
      const char* wanted = std::getenv("PENPOSE_FAULTS");
      const std::size_t only = wanted == nullptr ? 0 : std::strtoul(wanted, nullptr, 10);
      const bool all = wanted != nullptr && std::string(wanted) == "all";
      const std::size_t step = all ? 1 : calls / k_usual_runs + 1;
      for (std::size_t n = only != 0 ? only : 1; n <= (only != 0 ? only : calls); n += step) {
        for (const bool stays : {false, true}) {
          run_with(command, {kind, n, stays}, whole);
          if (HasFatalFailure()) return;
          ++runs;
        }
      }
    }
    RecordProperty("runs", static_cast<int>(runs));
    std::cout << runs << " runs\n";
    for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
      EXPECT_EQ(entry.path().filename().string().find(".part"), std::string::npos) << entry.path();
    }
  }
};

TEST_F(Faults, MemoryThatIsNotThereIsOneLine) { every_call_fails_once(FaultPlan::Kind::memory); }
TEST_F(Faults, FilesThatFailAreOneLine) { every_call_fails_once(FaultPlan::Kind::files); }

}  // namespace
}  // namespace penpose::tests
