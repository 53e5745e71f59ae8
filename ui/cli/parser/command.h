#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace penpose::cli {

// What commands see of the parser. It is CLI11, whose headers take longer to compile than any command; command.cpp
// alone includes them for what is declared here.

/// Says what is wrong with the text of a value; empty: nothing.
using Check = std::function<std::string(std::string&)>;

/// An option, flag or positional of a command. A handle: the parser owns what it stands for.
class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}

  const Option& required() const;
  /// `values`: which values pass, in words for --help; may be empty.
  const Option& check(Check check, std::string_view values = {}) const;
  const Option& one_of(const std::vector<std::string>& words) const;
  const Option& one_of_numbers(const std::vector<int>& numbers) const;
  const Option& between(int low, int high) const;
  const Option& between(double low, double high) const;
  const Option& needs(const Option& other) const;
  const Option& excludes(const Option& other) const;
  /// --help shows the value that is there now as the default.
  const Option& show_default() const;
  /// One value for each time that the option is given.
  const Option& one_value_a_time() const;
  /// --help leaves it out.
  const Option& hidden() const;

  friend bool operator==(const Option&, const Option&) = default;

 private:
  CLI::Option* option_;
};

/// A subcommand, or the program itself, while its options are added. Values outlive the parsing. `names`:
/// "-o,--output", or one name without a dash for a positional.
class Command {
 public:
  explicit Command(CLI::App& app) : app_(&app) {}

  Option add_option(const std::string& names, std::string& value, const std::string& help = "") const;
  Option add_option(const std::string& names, int& value, const std::string& help = "") const;
  Option add_option(const std::string& names, double& value, const std::string& help = "") const;
  Option add_option(const std::string& names, std::optional<double>& value, const std::string& help = "") const;
  Option add_option(const std::string& names, std::optional<int>& value, const std::string& help = "") const;
  Option add_option(const std::string& names, std::size_t& value, const std::string& help = "") const;
  Option add_option(const std::string& names, std::optional<std::size_t>& value, const std::string& help = "") const;
  Option add_option(const std::string& names, std::vector<std::string>& values, const std::string& help = "") const;
  /// An option of a text that `take` is called with.
  Option add_option(const std::string& names, const std::function<void(const std::string&)>& take,
                    const std::string& help) const;
  Option add_flag(const std::string& names, bool& value, const std::string& help = "") const;
  /// What --help ends with.
  void footer(const std::string& text) const;

 private:
  CLI::App* app_;
};

/// Adds a subcommand to the program; when it runs, `run` gives the exit status, which is stored in `status`.
Command add_subcommand(CLI::App& app, std::string_view name, const std::string& does, std::function<int()> run,
                       int& status);

}  // namespace penpose::cli
