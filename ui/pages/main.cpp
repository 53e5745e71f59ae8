// penpose_pages FOLDER DATE window|commands: writes the man pages and the completions of the program into FOLDER/man1,
// FOLDER/bash, FOLDER/zsh and FOLDER/fish. Run by the build; the command line itself is the table that they are made
// from.

#include <filesystem>
#include <fstream>
#include <iostream>
#include <string_view>

#include "ui/pages/completions.h"
#include "ui/pages/man_page.h"

namespace {

bool write(const std::filesystem::path& path, const std::string& text) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) std::cerr << "penpose_pages: " << path.string() << ": cannot be written\n";
  return static_cast<bool>(file);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::cerr << "usage: penpose_pages FOLDER DATE window|commands\n";
    return 2;
  }
  const std::filesystem::path folder(argv[1]);
  const auto table = penpose::cli::command_table(std::string_view(argv[3]) == "window");
  bool good = true;
  for (const auto& command : table) {
    good = write(folder / "man1" / penpose::pages::man_page_name(command),
                 penpose::pages::man_page(table, command, penpose::cli::program_version(), argv[2])) &&
           good;
  }
  good = write(folder / "bash" / "penpose", penpose::pages::bash_completion(table)) && good;
  good = write(folder / "zsh" / "_penpose", penpose::pages::zsh_completion(table)) && good;
  good = write(folder / "fish" / "penpose.fish", penpose::pages::fish_completion(table)) && good;
  return good ? 0 : 1;
}
