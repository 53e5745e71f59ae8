#include "ui/cli/parser/command.h"

#include <CLI/CLI.hpp>
#include <utility>

namespace penpose::cli {

const Option& Option::required() const {
  option_->required();
  return *this;
}
const Option& Option::check(Check check, std::string_view values) const {
  option_->check(CLI::Validator(std::move(check), std::string(values)));
  return *this;
}
const Option& Option::one_of(const std::vector<std::string>& words) const {
  option_->check(CLI::IsMember(words));
  return *this;
}
const Option& Option::one_of_numbers(const std::vector<int>& numbers) const {
  option_->check(CLI::IsMember(numbers));
  return *this;
}
const Option& Option::between(int low, int high) const {
  option_->check(CLI::Range(low, high));
  return *this;
}
const Option& Option::between(double low, double high) const {
  option_->check(CLI::Range(low, high));
  return *this;
}
const Option& Option::needs(const Option& other) const {
  option_->needs(other.option_);
  return *this;
}
const Option& Option::excludes(const Option& other) const {
  option_->excludes(other.option_);
  return *this;
}
const Option& Option::show_default() const {
  option_->capture_default_str();
  return *this;
}
const Option& Option::one_value_a_time() const {
  option_->allow_extra_args(false);
  return *this;
}
const Option& Option::hidden() const {
  option_->group("");
  return *this;
}

Option Command::add_option(const std::string& names, std::string& value, const std::string& help) const {
  return Option(app_->add_option(names, value, help));
}
Option Command::add_option(const std::string& names, int& value, const std::string& help) const {
  return Option(app_->add_option(names, value, help));
}
Option Command::add_option(const std::string& names, double& value, const std::string& help) const {
  return Option(app_->add_option(names, value, help));
}
Option Command::add_option(const std::string& names, std::optional<double>& value, const std::string& help) const {
  return Option(app_->add_option(names, value, help));
}
Option Command::add_option(const std::string& names, std::optional<int>& value, const std::string& help) const {
  return Option(app_->add_option(names, value, help));
}
Option Command::add_option(const std::string& names, std::size_t& value, const std::string& help) const {
  return Option(app_->add_option(names, value, help));
}
Option Command::add_option(const std::string& names, std::optional<std::size_t>& value, const std::string& help) const {
  return Option(app_->add_option(names, value, help));
}
Option Command::add_option(const std::string& names, std::vector<std::string>& values, const std::string& help) const {
  return Option(app_->add_option(names, values, help));
}
Option Command::add_option(const std::string& names, const std::function<void(const std::string&)>& take,
                           const std::string& help) const {
  return Option(app_->add_option_function<std::string>(names, take, help));
}
Option Command::add_flag(const std::string& names, bool& value, const std::string& help) const {
  return Option(app_->add_flag(names, value, help));
}

void Command::footer(const std::string& text) const { app_->footer(text); }

Command add_subcommand(CLI::App& app, std::string_view name, const std::string& does, std::function<int()> run,
                       int& status) {
  CLI::App* command = app.add_subcommand(std::string(name), does);
  command->callback([run = std::move(run), &status] { status = run(); });
  return Command(*command);
}

}  // namespace penpose::cli
