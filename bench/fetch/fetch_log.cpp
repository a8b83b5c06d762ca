#include "bench/fetch/fetch_log.h"

#include <algorithm>
#include <filesystem>
#include <vector>

#include <fmt/format.h>

#include "bench/fetch/curl.h"
#include "bench/fetch/get_file.h"
#include "bench/fetch/recipes.h"
#include "core/file/input_file.h"
#include "core/input_error.h"
#include "core/log/log_description.h"
#include "core/log/public_log.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

std::string path_in(const std::string& folder, const StoredFile& stored) {
  return (fs::path(folder) / stored.file).lexically_normal().string();
}

std::string below(const std::string& from, const std::string& name) {
  return is_address(from) ? address_below(from, name) : (fs::path(from) / name).string();
}

class Fetching {
 public:
  Fetching(const LogDescription& log, const FetchOptions& options, const FetchListener& listener)
      : log_(log),
        public_(load_public_log(log.yaml_path)),
        options_(options),
        listener_(listener) {}

  ~Fetching() {
    std::error_code ignored;
    for (const std::string& path : pieces_) fs::remove(path, ignored);
    for (const StoredFile* stored : missing_) remove_empty_folders(*stored);
  }
  Fetching(const Fetching&) = delete;
  Fetching& operator=(const Fetching&) = delete;

  void fetch() {
    for (const StoredFile* stored : stored_files(log_)) look_for(*stored);
    if (missing_.empty()) return;
    if (!options_.from.empty()) {
      take_finished();
    } else {
      tell_steps();
    }
    make_missing();
    if (!missing_.empty()) tell_missing();
  }

 private:
  void look_for(const StoredFile& stored) {
    const std::string path = path_in(options_.folder, stored);
    const Presence presence = presence_of(stored, log_, options_.folder);
    const fs::path beside = fs::path(log_.yaml_path).parent_path();
    if (presence == Presence::here) return say("already here: " + path);
    if (presence == Presence::missing &&
        presence_of(stored, log_, beside.string()) == Presence::here) {
      return say("already here: " + path_in(beside.string(), stored));
    }
    if (presence == Presence::another && !options_.force) {
      throw InputError({path},
                       "is another file than the one that " +
                           fs::path(log_.yaml_path).filename().string() + " describes",
                       "--force takes the described one in its place");
    }
    missing_.push_back(&stored);
  }

  // From a folder or a mirror that is laid out as the folder of logs, or has all in one place.
  void take_finished() {
    std::erase_if(missing_, [this](const StoredFile* stored) {
      const std::string name = fs::path(stored->file).filename().string();
      const std::string path = path_in(options_.folder, *stored);
      for (const std::string& file : {stored->file, name}) {
        const std::string place = below(options_.from, file);
        const MadeFile* const made = public_.making(stored->file);
        if (get(place, {path, 0, stored->sha256, made == nullptr ? "" : made->content})) {
          say(fmt::format("got {} from {}", path, place));
          return true;
        }
        if (stored->file == name) break;
      }
      return false;
    });
  }

  void make_missing() {
    std::erase_if(missing_, [this](const StoredFile* stored) {
      const MadeFile* const made = public_.making(stored->file);
      if (made == nullptr) return false;
      const std::string piece = piece_for(*made);
      if (piece.empty()) return false;
      const std::string path = path_in(options_.folder, *stored);
      make_file(piece, *made, stored->sha256, path);
      say(fmt::format("made {} of {}", path, made->piece));
      return true;
    });
  }

  // Where the public file is that the stored one is made of; empty where `from` has it not.
  std::string piece_for(const MadeFile& made) {
    const PublicFile& piece = public_.piece_of(made);
    const fs::path folder = fs::path(path_in(options_.folder, log_.log)).parent_path();
    const std::string path = (folder / ("fetched-" + piece.file)).string();
    if (std::find(pieces_.begin(), pieces_.end(), path) != pieces_.end()) return path;
    if (!get_piece(piece, path)) return {};
    pieces_.push_back(path);
    return path;
  }

  bool get_piece(const PublicFile& piece, const std::string& path) {
    const WantedFile wanted{path, piece.bytes, piece.sha256};
    std::vector<std::string> places = piece.addresses;
    if (!options_.from.empty()) places = {below(options_.from, piece.file)};
    for (const std::string& place : places) {
      if (!get(place, wanted)) continue;
      say(fmt::format("got {} from {}", piece.file, place));
      if (piece.sha256.empty()) {
        say("its checksum is not known: it is not verified, but what is made of it is");
      }
      return true;
    }
    if (!options_.from.empty()) return false;
    throw InputError({places.back()}, "nothing is there any more",
                     "name a folder or a mirror that has the file with --from");
  }

  bool get(const std::string& place, const WantedFile& wanted) {
    std::error_code failed;
    fs::create_directories(fs::path(wanted.path).parent_path(), failed);
    if (failed) {
      throw InputError({wanted.path}, "cannot be written: " + failed.message(),
                       "name another folder with --to");
    }
    const std::string file = fs::path(wanted.path).filename().string();
    return get_file(place, wanted, [&](std::uint64_t bytes) {
      return !listener_.goes_on || listener_.goes_on(file, bytes, wanted.bytes);
    });
  }

  // To the files that cannot be made; in front, as a network may fail for the others.
  void tell_steps() const {
    const auto is_made = [this](const StoredFile* stored) {
      return public_.making(stored->file) != nullptr;
    };
    if (std::all_of(missing_.begin(), missing_.end(), is_made)) return;
    say("by hand: " + log_.fetch);
    for (const std::string& piece : log_.pieces) say("  piece: " + piece);
    for (const PublicFile& piece : public_.pieces) {
      say(fmt::format("  public: {} (opened: {})", piece.addresses.front(), piece.opened));
    }
    int number = 0;
    for (const std::string& step : public_.by_hand) say(fmt::format("  {}. {}", ++number, step));
  }

  // Those that had to be made for files that did not come.
  void remove_empty_folders(const StoredFile& stored) const {
    std::error_code ignored;
    fs::path at = fs::path(stored.file).parent_path();
    while (!at.empty() && fs::remove(options_.folder / at, ignored)) at = at.parent_path();
  }

  [[noreturn]] void tell_missing() const {
    const std::string name = missing_.front()->file;
    if (!options_.from.empty()) {
      throw InputError({options_.from}, fmt::format("does not have {}", in_quotes(name)),
                       "leave --from out, for its public address or the steps to take");
    }
    throw InputError({fs::path(log_.yaml_path).filename().string()},
                     fmt::format("its file {} is made by hand", in_quotes(name)),
                     "take the steps above, or name a folder or a mirror that has it with --from");
  }

  void say(const std::string& line) const {
    if (listener_.say) listener_.say(line);
  }

  const LogDescription& log_;
  const PublicLog public_;
  const FetchOptions& options_;
  const FetchListener& listener_;
  std::vector<const StoredFile*> missing_;
  std::vector<std::string> pieces_;  // public files, which go when the log is made
};

}  // namespace

Presence presence_of(const StoredFile& stored, const LogDescription& log,
                     const std::string& folder) {
  const std::string path = path_in(folder, stored);
  std::error_code none;
  if (!fs::exists(path, none)) return Presence::missing;
  if (!fs::is_regular_file(path, none)) return Presence::another;
  return is_described(input_file(path), log, stored) ? Presence::here : Presence::another;
}

void fetch_log(const LogDescription& log, const FetchOptions& options,
               const FetchListener& listener) {
  Fetching(log, options, listener).fetch();
}

}  // namespace mapbed
