// golden HASHES THREADS SESSION|FOLDER...: replays every session named or in a folder named, and random ones in which
// every tool and every command comes as often as any other, prints the hash of the state at each session's end, and
// compares them with a file of lines "NAME HASH". With --print in place of the file it prints such a file. The text of
// a random session holds the state after each of its strokes and commands, so that its hash stands for all. Fails, too,
// where a kind of stroke is drawn in fewer than ten of the random sessions. Pictures that the processor draws of twelve
// scenes are compared in the same way.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/character/character.h"
#include "replay/session/session_player.h"
#include "tests/golden/pictures.h"
#include "tests/support/hands/knowing_hand.h"
#include "tests/support/parallel.h"

namespace {

using namespace penpose;  // NOLINT(google-build-using-namespace): a program of one file

constexpr std::uint64_t k_random_sessions = 40;
constexpr std::size_t k_actions = 54;
/// Each kind of stroke is drawn in as many sessions as that.
constexpr std::size_t k_least_of_a_kind = 10;

base::Result<document::Document> open(const std::string& path) {
  if (path == "test-sheet") return document::make_document(tests::sheet_model());
  auto made = character::Character::built_in(path);
  if (!made) return base::Error{"no golden session is drawn on " + path, "", ""};
  return made->document();
}

/// The state at the end, after all recorded states on the way were found equal.
base::Result<std::string> replayed(const std::string& text) {
  replay::PlayerOptions options;
  options.open = open;
  const auto played = replay::play_session(replay::read_from(base::as_bytes(text)), options);
  if (!played) return played.error();
  if (!played->session) return base::Error{"nothing to replay", "", ""};
  if (played->divergence) {
    return base::Error{"diverges", "line " + std::to_string(played->divergence->line), ""};
  }
  return played->session->editor().state().whole.hex();
}

/// A random session: its hash, and the kinds of strokes in it.
struct RandomSession {
  base::Result<std::string> hash = std::string();
  std::set<std::string> kinds;
};

RandomSession random_session(std::uint64_t seed) {
  tests::SessionScript script(document::make_document(tests::sheet_model()), "test-sheet");
  tests::KnowingHand hand(script, seed);
  hand.run(k_actions);
  const auto again = replayed(script.text());
  if (!again) return {again.error(), {}};
  if (*again != script.editor().state().whole.hex()) return {base::Error{"replays to another state", "", ""}, {}};
  return {base::hash_bytes(base::as_bytes(script.text())).hex(), hand.drawn_kinds()};
}

/// The files of sessions among paths of files and folders, by their names.
std::map<std::string, std::filesystem::path> session_files(int count, char** paths) {
  std::map<std::string, std::filesystem::path> files;
  const auto add = [&](const std::filesystem::path& path) {
    if (path.extension() == ".session") files[path.filename().string()] = path;
  };
  for (int i = 0; i < count; ++i) {
    if (!std::filesystem::is_directory(paths[i])) {
      add(paths[i]);
      continue;
    }
    for (const auto& entry : std::filesystem::directory_iterator(paths[i])) add(entry.path());
  }
  return files;
}

std::map<std::string, std::string> all_hashes(const std::map<std::string, std::filesystem::path>& files,
                                              std::size_t threads, bool& failed) {
  std::map<std::string, std::string> hashes;
  const auto keep = [&](const std::string& name, const base::Result<std::string>& hash) {
    if (hash) {
      hashes[name] = *hash;
      return;
    }
    std::cerr << name << ": " << hash.error().line() << '\n';
    failed = true;
  };
  hashes = tests::picture_hashes();
  for (const auto& [name, path] : files) {
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    keep(name, replayed(text));
  }
  // As many at a time as there are threads: nothing that one does may show in another.
  std::vector<RandomSession> random(k_random_sessions);
  tests::parallel_for(k_random_sessions, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) random[i] = random_session(i);
  });
  std::map<std::string, std::size_t> sessions_of_kind;
  for (const std::string_view kind : tests::KnowingHand::k_kinds) sessions_of_kind[std::string(kind)] = 0;
  sessions_of_kind.erase("none");
  for (std::size_t i = 0; i < k_random_sessions; ++i) {
    char name[16];
    std::snprintf(name, sizeof name, "random-%03d", static_cast<int>(i));
    keep(name, random[i].hash);
    for (const std::string& kind : random[i].kinds) ++sessions_of_kind[kind];
  }
  for (const auto& [kind, count] : sessions_of_kind) {
    if (count >= k_least_of_a_kind) continue;
    std::cerr << kind << ": drawn in " << count << " random sessions, fewer than " << k_least_of_a_kind << '\n';
    failed = true;
  }
  return hashes;
}

}  // namespace

int main(int argc, char** argv) {
  const int threads = argc < 4 ? 0 : std::atoi(argv[2]);
  if (threads < 1 || threads > 64) {
    std::cerr << "usage: golden HASHES|--print THREADS SESSION|FOLDER...\n";
    return 2;
  }
  bool failed = false;
  const auto hashes = all_hashes(session_files(argc - 3, argv + 3), static_cast<std::size_t>(threads), failed);
  if (std::strcmp(argv[1], "--print") == 0) {
    for (const auto& [name, hash] : hashes) std::cout << name << ' ' << hash << '\n';
    return failed ? 1 : 0;
  }
  std::ifstream file(argv[1]);
  std::map<std::string, std::string> golden;
  for (std::string name, hash; file >> name >> hash;) golden[name] = hash;
  for (const auto& [name, hash] : golden) {
    const auto found = hashes.find(name);
    if (found != hashes.end() && found->second == hash) continue;
    std::cerr << name << ": " << (found == hashes.end() ? "missing" : found->second) << ", golden is " << hash << '\n';
    failed = true;
  }
  for (const auto& [name, hash] : hashes) {
    if (golden.contains(name)) continue;
    std::cerr << name << ": has no golden hash\n";
    failed = true;
  }
  std::cout << hashes.size() << " sessions and pictures, " << (failed ? "not all equal" : "all equal") << '\n';
  return failed ? 1 : 0;
}
