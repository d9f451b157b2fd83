#include "base/command_line.h"

#include "base/text/nearest.h"
#include "base/text/printable.h"

#include <fmt/format.h>
#include <algorithm>
#include <CLI/CLI.hpp>
#include <map>
#include <stdexcept>
#include <utility>

namespace muelle {

CommandLineOption& CommandLineOption::required() {
  option_->required();
  return *this;
}

CommandLineOption& CommandLineOption::range(int low, int high) {
  option_->check(CLI::Range(low, high));
  return *this;
}

CommandLineOption& CommandLineOption::excludes(const CommandLineOption& other) {
  option_->excludes(other.option_);
  return *this;
}

CommandLineOption& CommandLineOption::separator(char between) {
  option_->delimiter(between);
  return *this;
}

CommandLineOption& CommandLineOption::oneOf(const std::vector<std::string>& words) {
  option_->check(CLI::IsMember(words));
  return *this;
}

CommandLineOption& CommandLineOption::showDefault() {
  option_->capture_default_str();
  return *this;
}

struct CommandLine::Parts {
  std::unique_ptr<CLI::App> owned;  // the program's own; a command belongs to its program's
  CLI::App* app = nullptr;
  std::function<int()> action;
  std::vector<std::string>* rest = nullptr;
  std::vector<std::unique_ptr<CommandLine>> commands;
  std::map<std::string, std::string> renamed;  // what an old name is called now

  /// The names of options that begin with "--", those that are read here and not by another program.
  std::vector<std::string> optionNames() const {
    std::vector<std::string> names;
    for (const CLI::Option* option : app->get_options()) {
      for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    return names;
  }

  /// CLI11 takes a mistyped command for a stray argument; its name deserves a better answer.
  void refuseUnknownCommand(const std::string& word) const {
    std::vector<std::string> names;
    for (const auto& command : commands) names.push_back(command->parts_->app->get_name());
    if (names.empty() || word.starts_with("-") || std::ranges::find(names, word) != names.end()) return;
    throw std::invalid_argument(fmt::format("no command '{}'{}", printableLine(word), suggestion(word, names)));
  }

  /// This command line, or that of the command which was asked for.
  Parts& chosen() {
    for (const auto& command : commands) {
      if (command->parts_->app->parsed()) return *command->parts_;
    }
    return *this;
  }

  /// CLI11's message, with the option that a mistyped one is near to.
  std::string complaint(const CLI::ParseError& error) const {
    const std::string message = error.what();
    if (dynamic_cast<const CLI::ExtrasError*>(&error) == nullptr) return message;
    for (const std::string& word : app->remaining()) {
      const std::string name = word.substr(0, word.find('='));
      if (const auto old = renamed.find(name); old != renamed.end()) return name + " is now " + old->second;
      if (word.starts_with("--")) return message + didYouMean(name, optionNames());
    }
    return message;
  }
};

CommandLine::CommandLine(const std::string& name, const std::string& description) : parts_(std::make_unique<Parts>()) {
  parts_->owned = std::make_unique<CLI::App>(description, name);
  parts_->app = parts_->owned.get();
}

CommandLine::CommandLine(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}

CommandLine::~CommandLine() = default;

CommandLineOption CommandLine::option(const std::string& names, std::string& target, const std::string& description) {
  return CommandLineOption(parts_->app->add_option(names, target, description));
}

CommandLineOption CommandLine::option(const std::string& names, int& target, const std::string& description) {
  return CommandLineOption(parts_->app->add_option(names, target, description));
}

CommandLineOption CommandLine::option(const std::string& names, double& target, const std::string& description) {
  return CommandLineOption(parts_->app->add_option(names, target, description));
}

CommandLineOption CommandLine::option(const std::string& names, std::uint64_t& target, const std::string& description) {
  return CommandLineOption(parts_->app->add_option(names, target, description));
}

CommandLineOption CommandLine::option(const std::string& names, std::optional<double>& target,
                                      const std::string& description) {
  return CommandLineOption(parts_->app->add_option(names, target, description));
}

CommandLineOption CommandLine::option(const std::string& names, std::vector<std::string>& target,
                                      const std::string& description) {
  return CommandLineOption(parts_->app->add_option(names, target, description));
}

CommandLineOption CommandLine::flag(const std::string& names, bool& target, const std::string& description) {
  return CommandLineOption(parts_->app->add_flag(names, target, description));
}

void CommandLine::renamed(const std::string& old, const std::string& now) { parts_->renamed[old] = now; }

void CommandLine::footer(const std::string& text) { parts_->app->footer(text); }

void CommandLine::action(std::function<int()> body) { parts_->action = std::move(body); }

CommandLine& CommandLine::command(const std::string& name, const std::string& description) {
  auto parts = std::make_unique<Parts>();
  parts->app = parts_->app->add_subcommand(name, description);
  parts_->commands.push_back(std::unique_ptr<CommandLine>(new CommandLine(std::move(parts))));
  return *parts_->commands.back();
}

void CommandLine::passOn(std::vector<std::string>& words) {
  parts_->app->set_help_flag();
  parts_->app->prefix_command();
  parts_->rest = &words;
}

int CommandLine::run(int argc, const char* const* argv) {
  if (argc > 1) parts_->refuseUnknownCommand(argv[1]);
  try {
    parts_->app->parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // Calls for help are "errors" too, with exit code 0.
    if (error.get_exit_code() == 0) return parts_->app->exit(error);
    const Parts& asked = parts_->chosen();
    const std::string name = parts_->app->get_name();
    if (name.empty()) throw std::invalid_argument(asked.complaint(error));
    const std::string command = &asked == parts_.get() ? "" : asked.app->get_name() + " ";
    throw std::invalid_argument(fmt::format("{} (see {} {}--help)", asked.complaint(error), name, command));
  }
  const Parts& asked = parts_->chosen();
  if (asked.rest != nullptr) *asked.rest = asked.app->remaining();
  return asked.action ? asked.action() : 0;
}

}  // namespace muelle
