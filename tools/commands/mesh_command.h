// `sbeh mesh`: a shape becomes a curved mesh in a file, a report, or both.
#pragma once

#include "studies/mesh/make_mesh.h"

#include <memory>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace sbeh::tools {

class MeshCommand {
 public:
  /// Adds the command and its shapes.
  explicit MeshCommand(CLI::App& app);

  /// Makes, writes and reports what the parsed command line asks for; the exit code. Throws
  /// studies::InputError and studies::OutputError.
  int run() const;

 private:
  struct Words;  // as they stand on the command line
  std::shared_ptr<Words> words_;
};

}  // namespace sbeh::tools
