// serve: fabserver, a page in the browser with its render server; part of the Python package
// (fieldfab.serve).
#include "verbs.h"

namespace fieldfab::cli {
namespace {

class ServeVerb final : public Verb {
 public:
  void declare(CLI::App& app) override {
    verb_ =
        app.add_subcommand("serve", "design in a browser: a page, its render server and its workers, on this machine");
    verb_->add_option("FOLDER", folder_, "where the documents are (default: the current folder)");
    verb_->add_option("--port", port_, "port to listen on; 0 takes a free one (default: 8765, or a free one)")
        ->check(CLI::Range(0, 65535));
    verb_->add_option("--host", host_,
                      "address to listen on; any but this machine's own demands a token (default: 127.0.0.1)");
    verb_->add_option(
        "--scheduler", scheduler_,
        "address of a Dask scheduler, such as tcp://host:8786: files are made there, not on this machine");
    verb_->add_flag("--no-browser", no_browser_, "open no browser");
    verb_->add_flag("--allow-scripts", allow_scripts_,
                    "run .py, .ko and .scad texts from the browser: they can do whatever you can");
  }
  Outcome run(Progress& /*progress*/) override {
    std::vector<std::string> words{"--host", host_};
    if (port_) words.insert(words.end(), {"--port", std::to_string(*port_)});
    if (!scheduler_.empty()) words.insert(words.end(), {"--scheduler", scheduler_});
    if (no_browser_) words.emplace_back("--no-browser");
    if (allow_scripts_) words.emplace_back("--allow-scripts");
    words.insert(words.end(), {"--", folder_});
    become_python("fieldfab.serve", words);
  }

 private:
  std::string folder_ = ".", host_ = "127.0.0.1", scheduler_;
  std::optional<int> port_;
  bool no_browser_ = false, allow_scripts_ = false;
};

}  // namespace

std::unique_ptr<Verb> serve_verb() { return std::make_unique<ServeVerb>(); }

}  // namespace fieldfab::cli
