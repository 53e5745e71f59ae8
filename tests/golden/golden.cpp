// golden HASHES THREADS SESSION|FOLDER...: replays every session named or in a folder named, 200 random ones, and for
// each of the rules 1 to 7 another 40 in which every command of the list comes as often as any other (by rules 5
// another 40 with the commands that came later), prints the hash of the state at each session's end, and compares them
// with a file of lines "NAME HASH". With --print in place of the file it prints such a file. The text of a random
// session holds the state after each of its strokes and commands, so that its hash stands for all.

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "core/head/head.h"
#include "replay/session/session_player.h"
#include "tests/support/hands/knowing_hand.h"
#include "tests/support/parallel.h"

namespace {

using namespace penpose;  // NOLINT(google-build-using-namespace): a program of one file

constexpr std::uint64_t k_random_sessions = 200;
constexpr std::size_t k_actions = 25;
/// Sessions in which every command of the list comes as often as any other.
constexpr std::uint64_t k_knowing_sessions = 40;
constexpr std::size_t k_knowing_actions = 80;

base::Result<document::Document> open(const std::string& path) {
  if (path == "builtin:head") return document::make_document(head::make_head());
  if (path == "builtin:head") return document::make_document(head::make_head());
  if (path == "builtin:head") return document::make_document(head::make_head());
  if (path == "builtin:head") return document::make_document(head::make_head());
  if (path == "test-sheet") return document::make_document(tests::sheet_model());
  return base::Error{"no golden session is drawn on " + path, "", ""};
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

template <typename Hand, typename... Rules>
base::Result<std::string> random_session(std::uint64_t seed, std::size_t actions, Rules... rules) {
  tests::SessionScript script(document::make_document(tests::sheet_model()), "test-sheet");
  Hand(script, seed, rules...).run(actions);
  const auto again = replayed(script.text());
  if (!again) return again.error();
  if (*again != script.editor().state().whole.hex()) return base::Error{"replays to another state", "", ""};
  return base::hash_bytes(base::as_bytes(script.text())).hex();
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
  for (const auto& [name, path] : files) {
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    keep(name, replayed(text));
  }
  // As many at a time as there are threads: nothing that one does may show in another.
  constexpr std::uint64_t k_all = k_random_sessions + 8 * k_knowing_sessions;
  std::vector<base::Result<std::string>> random(k_all, std::string());
  tests::parallel_for(k_all, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (i < k_random_sessions) {
        random[i] = random_session<tests::RandomHand>(i, k_actions);
        continue;
      }
      const std::uint64_t seed = (i - k_random_sessions) % k_knowing_sessions;
      // Rules 1 to 5, then 5 with the commands that came after them, then 6 and 7.
      const auto row = static_cast<std::uint32_t>(1 + (i - k_random_sessions) / k_knowing_sessions);
      using Commands = tests::KnowingHand::Commands;
      random[i] = row == 6 ? random_session<tests::KnowingHand>(seed, k_knowing_actions, 5U, Commands::targets)
                           : random_session<tests::KnowingHand>(seed, k_knowing_actions, row > 6 ? row - 1 : row);
    }
  });
  for (std::size_t i = 0; i < k_all; ++i) {
    // By the rules: 0, then 1 to 5, then 5 with the commands of several targets, then 6 and 7.
    constexpr std::array<const char*, 9> k_names{"random-%03d", "every-%03d",  "meant-%03d",
                                                 "sheet-%03d",  "offset-%03d", "moment-%03d",
                                                 "target-%03d", "whole-%03d",  "ended-%03d"};
    const std::uint64_t rules = i < k_random_sessions ? 0 : 1 + (i - k_random_sessions) / k_knowing_sessions;
    const std::uint64_t number = rules == 0 ? i : (i - k_random_sessions) % k_knowing_sessions;
    char name[16];
    std::snprintf(name, sizeof name, k_names.at(rules), static_cast<int>(number));
    keep(name, random[i]);
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
  std::cout << hashes.size() << " sessions, " << (failed ? "not all equal" : "all equal") << '\n';
  return failed ? 1 : 0;
}
