// edit: live view of a model, a window of the Python package (fieldfab.edit).
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/solid/script.h"
#include "verbs.h"

namespace fieldfab::cli {
namespace {

class EditVerb final : public Verb {
 public:
  void declare(CLI::App& app) override {
    verb_ = app.add_subcommand("edit", "show a model in a window, updated whenever its file is saved");
    verb_->add_option("MODEL", file_, "a .frep, .math, .vm, .py or .asdf file; a .py script is run")->required();
  }
  Outcome run(Progress& /*progress*/) override {
    require_regular_file(file_);
    if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr &&
        std::getenv("QT_QPA_PLATFORM") == nullptr)
      throw Error(ErrorKind::bad_input, "edit", "there is no screen to show a window on");
    become_python("fieldfab.edit", {file_});
  }

 private:
  std::string file_;
};

}  // namespace

void become_python(const std::string& module, const std::vector<std::string>& arguments) {
  // -P: a json.py in the current folder is the user's, and not Python's.
  std::vector<std::string> words{python_program(), "-P", "-m", module};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<std::string> environment = python_environment();
  std::vector<char*> argv, env;
  for (std::string& word : words) argv.push_back(word.data());
  for (std::string& word : environment) env.push_back(word.data());
  argv.push_back(nullptr), env.push_back(nullptr);
  execve(argv[0], argv.data(), env.data());
  throw Error(ErrorKind::io, words[0], std::strerror(errno));
}

std::unique_ptr<Verb> edit_verb() { return std::make_unique<EditVerb>(); }

}  // namespace fieldfab::cli
