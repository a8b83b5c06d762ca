#include "bench/sources/files_record.h"

#include <filesystem>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "bench/results/flow_text.h"
#include "core/config/config_node.h"
#include "core/data_path.h"

namespace mapbed {
namespace {

// A path has two checksums where the file changed while the plan was made.
std::map<std::string, std::string> checksums(const InputFiles& files) {
  std::map<std::string, std::string> by_path;
  for (const InputFile& file : files) by_path[portable_path(file.path)] += file.sha256;
  return by_path;
}

std::vector<std::string> changed_in(const ConfigNode& config,
                                    const std::map<std::string, std::string>& now) {
  const ConfigNode* files = config.find("files");
  if (files == nullptr) return {};
  std::vector<std::string> changed;
  for (const ConfigNode& file : files->items()) {
    const auto found = now.find(file.at("path").text());
    if (found == now.end() || found->second == file.at("sha256").text()) continue;
    changed.push_back(found->first);
  }
  return changed;
}

}  // namespace

std::string files_yaml(const InputFiles& files) {
  if (files.empty()) return "";
  std::string text = "files:  # that this was made of\n";
  for (const auto& [path, sha256] : checksums(files)) {
    text += "  - " + flow_map({{"path", flow_scalar(path)}, {"sha256", sha256}}) + "\n";
  }
  return text;
}

std::vector<std::string> changed_files(const std::string& config_path, const InputFiles& now) {
  if (!std::filesystem::exists(config_path)) return {};
  try {
    return changed_in(load_config(config_path), checksums(now));
  } catch (const InputError&) {
    return {};  // of somebody else, or damaged: nothing is known of its files
  }
}

std::string told_changes(const std::string& config_path, const InputFiles& now) {
  const std::vector<std::string> changed = changed_files(config_path, now);
  if (changed.empty()) return "";
  return fmt::format("{} changed since {} was written", fmt::join(changed, ", "), config_path);
}

}  // namespace mapbed
