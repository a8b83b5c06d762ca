#include "bench/methods/program_method.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "algorithms/methods.h"
#include "bench/methods/command_text.h"
#include "bench/methods/work_folder.h"
#include "bench/process/child_process.h"
#include "core/config/config_node.h"
#include "core/config/option.h"
#include "core/data_path.h"
#include "core/file/utf8.h"
#include "core/log/log_formats.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFolder = "scenarios/methods";
constexpr double kVersionLimit = 10.0;           // [s] for telling a version
constexpr std::size_t kLongestVersion = 200;     // [bytes]
constexpr Bounds kLimits = between(0.001, 1e7);  // [s]

const std::vector<std::string> kGiven{"log", "geometry", "stamps", "out", "seed"};

// Words with a meaning of their own before a dot, in scenarios and in configurations of maps.
const std::vector<std::string> kTaken{"doubled", "driver",     "faults", "input", "log",
                                      "map",     "people",     "path",   "robot", "recorder",
                                      "seeds",   "simulation", "world"};

bool contains(const std::vector<std::string>& all, const std::string& one) {
  return std::find(all.begin(), all.end(), one) != all.end();
}

void check_name(const std::string& name, const std::string& file) {
  const auto is_plain = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
  };
  if (name.empty() || !std::all_of(name.begin(), name.end(), is_plain)) {
    throw InputError({file},
                     "its name becomes that of a method, and has more than letters, digits, "
                     "'_' and '-'",
                     "rename the file");
  }
  bool is_taken = contains(kTaken, name);
  for (const Method& method : methods()) is_taken = is_taken || method.name == name;
  if (is_taken) {
    throw InputError({file}, "its name, " + in_quotes(name) + ", means something else here",
                     "rename the file");
  }
}

// A file or folder of the program's own, below the one in which it runs.
std::string own_path(const ConfigNode& node) {
  const fs::path path = fs::path(node.text()).lexically_normal();
  const bool leads_out = path.is_absolute() || path.empty() || *path.begin() == "..";
  if (!leads_out) return path.string();
  throw InputError(node.place(), in_quotes(node.text()) + " is not below the program's folder",
                   "it runs in a folder of its own, which is '{out}'");
}

void check_new_placeholder(const std::string& name, const ProgramMethod& method,
                           const ConfigNode& node) {
  const bool is_word =
      !name.empty() &&
      name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos;
  if (!is_word) {
    throw InputError(node.place(), in_quotes(name) + " cannot stand in braces",
                     "take small letters, digits and '_'");
  }
  if (contains(kGiven, name) || name == "limit" || method.files.contains(name) ||
      method.options.contains(name)) {
    throw InputError(node.place(), in_quotes(name) + " has a meaning already", "take another name");
  }
}

std::vector<std::string> known_placeholders(const ProgramMethod& method) {
  std::vector<std::string> known = kGiven;
  for (const auto& [name, path] : method.files) known.push_back(name);
  for (const auto& [name, value] : method.options) known.push_back(name);
  return known;
}

void read_named(const ConfigNode& file, ProgramMethod& method) {
  if (const ConfigNode* files = file.find("files")) {
    for (const std::string& name : files->keys()) {
      const ConfigNode& node = files->at(name);
      check_new_placeholder(name, method, node);
      const fs::path path = fs::path(node.place().file).parent_path() / node.text();
      const std::string whole = fs::absolute(path).lexically_normal().string();
      if (!fs::is_regular_file(whole)) {
        throw InputError(node.place(), in_quotes(node.text()) + " is no file",
                         "its path counts from the folder of this file");
      }
      method.files[name] = whole;
    }
  }
  if (const ConfigNode* options = file.find("options")) {
    for (const std::string& name : options->keys()) {
      const ConfigNode& node = options->at(name);
      check_new_placeholder(name, method, node);
      method.options[name] = with_whole_path(node.text(), node.place());
    }
  }
}

// Its command or script, checked. Returns where it stands.
SourceLocation read_command(const ConfigNode& file, ProgramMethod& method) {
  const ConfigNode* command = file.find("command");
  const ConfigNode* shell = file.find("shell");
  if ((command == nullptr) == (shell == nullptr)) {
    throw InputError(file.place(), "needs one of 'command' and 'shell'",
                     "as in command: [my_slam, \"{log}\", trajectory.tum]");
  }
  method.is_shell = shell != nullptr;
  const ConfigNode& node = method.is_shell ? *shell : *command;
  method.command = method.is_shell ? std::vector<std::string>{node.text()} : node.texts();
  if (method.command.empty() || method.command.front().empty()) {
    throw InputError(node.place(), "names no program", "its first word is the program");
  }
  bool has_log = false;
  for (const std::string& word : method.command) {
    check_placeholders(word, known_placeholders(method), node.place());
    has_log = has_log || contains(placeholders_in(word), "log");
  }
  if (!has_log) {
    throw InputError(node.place(), "has no placeholder '{log}', so the program gets no log",
                     "put \"{log}\" where it takes the log's path");
  }
  return node.place();
}

// The program's own file: the one that its first word, or 'program', names.
InputFile program_file(const ConfigNode& file, ProgramMethod& method,
                       const SourceLocation& of_command) {
  const ConfigNode* named = file.find("program");
  const ConfigNode* install = file.find("install");
  const std::string how = install == nullptr ? "" : install->text();
  if (named == nullptr && method.is_shell) {
    throw InputError(of_command, "does not say which program it is about",
                     "add 'program: NAME', whose file is part of what a result is made of");
  }
  const SourceLocation place = named == nullptr ? of_command : named->place();
  Placeholders files(method.files.begin(), method.files.end());
  const std::string word = named == nullptr ? method.command.front() : named->text();
  for (const std::string& name : placeholders_in(word)) {
    if (files.contains(name)) continue;
    throw InputError(place, "the program's name has a placeholder that is no file",
                     "name the program itself");
  }
  const std::string name = with_whole_path(filled(word, files), place);
  // From where the program will run, a relative path leads elsewhere.
  if (!method.is_shell && named == nullptr) method.command.front() = name;
  const std::string path = program_in_path(name);
  if (!path.empty()) return input_file(path);
  throw InputError(place, "the program " + in_quotes(name) + " is not there, or cannot be run",
                   how.empty() ? "install it, so that it is found in PATH" : how);
}

// What its 'version' command prints first; empty where that fails.
std::string version_of(const std::vector<std::string>& command) {
  if (command.empty() || program_in_path(command.front()).empty()) return "";
  const WorkFolder folder;
  const std::string messages = folder.path("version");
  const ChildEnd end = run_child({command, folder.path("."), messages, kVersionLimit});
  if (!end.is_success()) return "";
  std::ifstream text(messages);
  std::string line;
  while (line.empty() && std::getline(text, line)) {
  }
  line = escaped_utf8(line.substr(0, kLongestVersion));
  std::replace_if(
      line.begin(), line.end(), [](char c) { return c >= 0 && c < ' '; }, ' ');
  return line;
}

OptionList settable(ProgramMethod& method) {
  OptionList list{{"limit", &method.limit, Unit::second, kLimits, "of wall time"}};
  for (auto& [name, value] : method.options) {
    list.push_back({name, &value, Unit::none, kAnyValue, "an option of the program's own"});
  }
  return list;
}

fs::path path_of(const std::string& name_or_path) {
  return fs::absolute(find_data_file("method", kFolder, name_or_path)).lexically_normal();
}

}  // namespace

std::string ProgramMethod::complete_yaml() const {
  ProgramMethod copy = *this;
  const std::string stated = version.empty() ? "no version" : "version " + version;
  return "# a program that states " + stated + "\n" + to_yaml(settable(copy));
}

std::string ProgramMethod::description() const {
  std::string text = complete_yaml() + "made of:\n";
  for (const InputFile& file : input_files) text += "  " + file.path + "\n";
  return text;
}

bool is_program_file(const std::string& path) {
  std::error_code failed;
  if (!path.ends_with(".yaml") || !fs::is_regular_file(path, failed)) return false;
  const ConfigNode file = load_config(path);
  return file.kind() == ConfigNode::Kind::map &&
         (file.find("command") != nullptr || file.find("shell") != nullptr);
}

bool is_program_method(const std::string& name_or_path) {
  return name_or_path.find('/') != std::string::npos || name_or_path.ends_with(".yaml") ||
         contains(program_method_names(), name_or_path);
}

std::string program_method_name(const std::string& name_or_path) {
  return fs::path(name_or_path).stem().string();
}

std::vector<std::string> program_method_names() {
  return data_names(kFolder);
}

ProgramMethod load_program_method(const std::string& name_or_path, const Settings& settings) {
  const std::string path = path_of(name_or_path).string();
  ProgramMethod method{.name = program_method_name(name_or_path)};
  check_name(method.name, path);
  method.input_files = {input_file(path)};
  const ConfigNode file = load_config(path);
  if (const ConfigNode* about = file.find("about")) method.about = about->text();
  read_named(file, method);
  const SourceLocation of_command = read_command(file, method);
  if (const ConfigNode* log = file.find("log")) {
    method.log_format = log_format_by_name(log->text(), log->place()).name;
  }
  if (const ConfigNode* trajectory = file.find("trajectory")) {
    method.trajectory = own_path(*trajectory);
  }
  if (const ConfigNode* keep = file.find("keep")) {
    for (const ConfigNode& kept : keep->items()) method.keep.push_back(own_path(kept));
  }
  if (const ConfigNode* limit = file.find("limit")) {
    method.limit = limit->number(Unit::second, kLimits);
  }
  std::vector<std::string> version;
  if (const ConfigNode* command = file.find("version")) version = command->texts();
  (void)file.find("program");
  (void)file.find("install");
  file.check_all_used("a method's file");
  apply(settings, settable(method), method.name);
  const InputFile program = program_file(file, method, of_command);
  merge({program}, method.input_files);
  for (const auto& [name, whole] : method.files) merge({input_file(whole)}, method.input_files);
  method.version = version_of(version);
  return method;
}

}  // namespace mapbed
