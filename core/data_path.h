#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/input_error.h"

namespace mapbed {

// A word may be a name or the path of a file. Where it is no name that is known, a file may be
// meant that is called so and ends in one of `endings`, in the folder from which paths at `place`
// count (with_whole_path).
struct FilesCalledSo {
  SourceLocation place = {};
  std::vector<std::string> endings = {};
};

const FilesCalledSo& yaml_files();  // in the working folder

// "did you mean ./mine.yaml?" where there is such a file, else the suggestion() of the names: the
// remedy of an InputError.
std::string name_or_path_suggestion(const std::string& word, const std::vector<std::string>& names,
                                    const FilesCalledSo& files = yaml_files());

// The folder that holds robots/, scenarios/ and the like: the environment's MAPBED_HOME; else the
// installed share/mapbed beside the running program, or where the library was installed; else the
// source tree. Throws InputError where MAPBED_HOME names no folder or where none of them exists.
std::filesystem::path data_home();

// A data file by its name ("b21r", with `folder` "robots") or by its own path ("my/robot.yaml": has
// a '/' or ends in .yaml). Throws InputError with the nearest name where there is none; `kind` is
// what the message calls it ("robot").
std::filesystem::path find_data_file(const std::string& kind, const std::string& folder,
                                     const std::string& name_or_path,
                                     const FilesCalledSo& files = yaml_files());

// Where the file is that a value names, from the root: a relative path counts from the folder of
// the file in which the value stands, `place`; one without a line stands on the command line, and
// counts from the working folder. Every other value stays as it is. A path ends in .yaml, begins
// with ./ or ../, or has a '/' or '.' and leads to a file, or has a '/' and leads to a folder.
std::string with_whole_path(const std::string& value, const SourceLocation& place);

// A file's path on every machine: that of a data file counts from data_home()
// ("robots/b21r.yaml"), one below the environment's MAPBED_DATA from there. Any other stays as it
// is, also where somebody keeps it in the source tree.
std::string portable_path(const std::string& path);

// The names of the .yaml files in a folder of data_home(), sorted.
std::vector<std::string> data_names(const std::string& folder);

}  // namespace mapbed
