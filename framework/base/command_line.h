#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class Option;
}

namespace muelle {

/// What can be asked of an option after it has been added; each returns the option, to be chained.
class CommandLineOption {
 public:
  explicit CommandLineOption(CLI::Option* option) : option_(option) {}

  CommandLineOption& required();
  /// Only whole numbers from `low` to `high`.
  CommandLineOption& range(int low, int high);
  /// The two are not given together.
  CommandLineOption& excludes(const CommandLineOption& other);
  /// One word may hold several values.
  CommandLineOption& separator(char between);
  /// Only these words.
  CommandLineOption& oneOf(const std::vector<std::string>& words);
  /// --help shows the value that the target has now.
  CommandLineOption& showDefault();

 private:
  CLI::Option* option_;
};

/// A program's command line, or that of one of its commands: options that are read into variables, and what is done
/// afterwards. The library behind it (CLI11) is compiled in one source only. Variables and actions must outlive run().
class CommandLine {
 public:
  /// `name` is what one types to start the program; --help shows it, and errors send there. Without it they do not.
  CommandLine(const std::string& name, const std::string& description);
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  /// An option "--out", "--jobs,-j", or a positional argument "NAME". A target that holds a list takes several words.
  CommandLineOption option(const std::string& names, std::string& target, const std::string& description);
  CommandLineOption option(const std::string& names, int& target, const std::string& description);
  CommandLineOption option(const std::string& names, double& target, const std::string& description);
  CommandLineOption option(const std::string& names, std::uint64_t& target, const std::string& description);
  CommandLineOption option(const std::string& names, std::optional<double>& target, const std::string& description);
  CommandLineOption option(const std::string& names, std::vector<std::string>& target, const std::string& description);
  /// An option without a value.
  CommandLineOption flag(const std::string& names, bool& target, const std::string& description);

  /// A name that an option no longer has: refused in a line that ends in `now`, "--step SECONDS".
  void renamed(const std::string& old, const std::string& now);

  /// Lines below the options in --help.
  void footer(const std::string& text);
  /// What run() does when this command was asked for; its result is the exit code.
  void action(std::function<int()> body);

  /// Adds a command, which this command line owns.
  CommandLine& command(const std::string& name, const std::string& description);
  /// Leaves everything that follows the command's name, --help too, in `words`: another program reads it.
  void passOn(std::vector<std::string>& words);

  /// Reads the arguments, then does the action of the command that was asked for, or this one's own, and returns its
  /// exit code. --help is printed, and 0 returned. Throws std::invalid_argument with one line when the arguments are
  /// wrong: a mistyped command or option is answered with the name that is nearest.
  int run(int argc, const char* const* argv);

 private:
  struct Parts;
  explicit CommandLine(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace muelle
