// `sbeh figures`: the paper's figures, with the runs they need.
#pragma once

#include <memory>

namespace CLI {
class App;
}

namespace sbeh::tools {

class FiguresCommand {
 public:
  /// Adds the command.
  explicit FiguresCommand(CLI::App& app);

  bool parsed() const;

  /// Runs, draws and prints what the parsed command line asks for; the exit code. Throws
  /// studies::InputError and studies::OutputError.
  int run() const;

 private:
  struct Words;  // as they stand on the command line
  std::shared_ptr<Words> words_;
};

}  // namespace sbeh::tools
