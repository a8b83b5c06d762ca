#include "bench/results/run_files.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

namespace mapbed {
namespace {

namespace fs = std::filesystem;

// Of a text that becomes a part of a file's name.
std::string slug_of(const std::string& text) {
  std::string slug;
  for (const char c : text) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-';
    if (plain) slug += c;
    if (!plain && !slug.empty() && slug.back() != '_') slug += '_';
  }
  while (!slug.empty() && slug.back() == '_') slug.pop_back();
  return slug;
}

// Of a variant; where no letter is left of it, or another one has the same, its number.
std::string slug_of_variant(const Results& results, int variant) {
  const auto slug = [&](std::size_t i) { return slug_of(results.variants[i]); };
  const auto index = static_cast<std::size_t>(variant);
  bool is_its_own = !slug(index).empty();
  for (std::size_t i = 0; i < results.variants.size(); ++i) {
    if (i != index && slug(i) == slug(index)) is_its_own = false;
  }
  return is_its_own ? slug(index) : fmt::format("variant_{}", variant);
}

// "_level_2_raw": what tells the file of this run from those of others.
std::string suffix_of(const RunRow& run, const Results& results) {
  std::string suffix;
  if (results.levels.size() > 1) suffix += fmt::format("_level_{}", run.level);
  if (results.variants.size() > 1) {
    suffix += "_" + slug_of_variant(results, run.variant);
  }
  return suffix;
}

// Digits padded with zeros.
std::string sort_key(const std::string& name) {
  constexpr std::size_t kDigits = 12;
  std::string key, number;
  const auto flush = [&] {
    if (!number.empty()) key.append(kDigits - std::min(kDigits, number.size()), '0').append(number);
    number.clear();
  };
  for (const char c : name) {
    if (c >= '0' && c <= '9') {
      number += c;
      continue;
    }
    flush();
    key += c;
  }
  flush();
  return key;
}

}  // namespace

FileOfRun file_of_run(const ResultFile& file, const RunRow& run, const Results& results) {
  const fs::path path(file.path);
  const std::string stem = path.stem().string();
  const std::string name = stem + suffix_of(run, results) + path.extension().string();
  std::string title = file.title;
  if (title.empty()) {
    title = stem;
    std::replace(title.begin(), title.end(), '_', ' ');
  }
  return {(path.parent_path() / name).string(), run.run, title};
}

std::vector<FileOfRun> files_by_name(const std::vector<std::string>& paths,
                                     const Results& results) {
  std::vector<FileOfRun> files;
  for (const std::string& path : paths) {
    const fs::path whole(path);
    const std::string stem = whole.stem().string();
    // The longest suffix: "raw" of two variants "raw" and "not raw" fits both.
    const RunRow* best = nullptr;
    std::size_t longest = 0;
    for (const RunRow& run : results.runs) {
      const std::string suffix = suffix_of(run, results);
      if (run.seed != results.seed || !stem.ends_with(suffix)) continue;
      if (best != nullptr && suffix.size() <= longest) continue;
      best = &run;
      longest = suffix.size();
    }
    if (best == nullptr) continue;
    const std::string bare = stem.substr(0, stem.size() - longest) + whole.extension().string();
    FileOfRun file = file_of_run({(whole.parent_path() / bare).string(), ""}, *best, results);
    file.path = path;
    files.push_back(std::move(file));
  }
  return files;
}

bool in_natural_order(const std::string& a, const std::string& b) {
  return std::pair(sort_key(a), a) < std::pair(sort_key(b), b);
}

}  // namespace mapbed
