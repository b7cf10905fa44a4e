#include "app/commands/keys_command.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "app/study/study_documentation.hpp"

namespace isopatch::app {
namespace {

constexpr const char* keys_examples = R"(Examples:
  isopatch keys                 everything, as Markdown
  isopatch keys support         one section, or the sections with a key of that name)";

}  // namespace

ExitCode keys_command(const std::string& topic, const Console& console) {
  console.out << study_documentation(topic);
  return ExitCode::ok;
}

void add_keys_command(CLI::App& app, CommandLine& line) {
  const auto topic = std::make_shared<std::string>();
  add_command(app, line, "keys", "Documents the keys of the study file", keys_examples,
              [topic](const Console& console) { return keys_command(*topic, console); })
      .add_option("topic", *topic, "A section or a key, for example support");
}

}  // namespace isopatch::app
