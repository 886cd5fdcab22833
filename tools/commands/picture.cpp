// `sbeh picture`: the program that draws, beside this one.
#include "studies/io/progress.h"
#include "tools/commands/commands.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>

namespace sbeh::tools {

int draw(const std::vector<std::string>& arguments) {
  namespace fs = std::filesystem;
  std::fflush(nullptr);
  const fs::path program = fs::read_symlink("/proc/self/exe").parent_path() / "sbeh-picture";
  std::vector<std::string> words{program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const pid_t child = fork();
  if (child == 0) {
    std::vector<char*> argv;
    argv.reserve(words.size() + 1);
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    execv(program.c_str(), argv.data());
    studies::tell(fmt::format("sbeh: {}: cannot be started\n", program.string()));
    _exit(127);
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) < 0) return 127;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

Command add_picture(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("picture",
                             "draw the pictures of a folder again: picture "
                             "scan|relax|run|seifert|compare|figures|stability|modes|states|"
                             "diagram "
                             "DIR");
  app->prefix_command();
  app->set_help_flag();  // `sbeh picture --help` is the picture program's
  return {app, [app] { return draw(app->remaining()); }};
}

}  // namespace sbeh::tools
