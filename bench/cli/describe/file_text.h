#pragma once

#include <optional>
#include <string>

namespace mapbed {

// What a file or folder is and holds, of every kind that any command reads.
struct FileText {
  std::string kind;  // "map", "trajectory"
  std::string text;  // lines
};

// None where there is no such file or folder. Throws InputError, which names the kinds that are
// read, where it is of none of them, and where it is of one but broken.
std::optional<FileText> text_of_file(const std::string& path);

// The same of a YAML file, by its keys; none where they are those of no kind.
std::optional<FileText> text_of_yaml(const std::string& path);

// A map and the share of its cells that are known; `path` is of its YAML file, or of a picture
// with such a file beside it.
FileText text_of_map(const std::string& path);

// What a sensor or robot promises, in one line, and which document that is from: what its file says
// as `source`, else the file itself.
std::string promise_of_sensor(const std::string& name_or_path);
std::string promise_of_robot(const std::string& name_or_path);

// That, and the options.
FileText text_of_sensor(const std::string& name_or_path);
FileText text_of_robot(const std::string& name_or_path);

// What a config.yaml of results belongs to: the scenario, its runs, claims and version.
FileText text_of_results(const std::string& folder);

}  // namespace mapbed
