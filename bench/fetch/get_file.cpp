#include "bench/fetch/get_file.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

#include <fmt/format.h>

#include "bench/fetch/curl.h"
#include "core/file/atomic_file.h"
#include "core/file/hash.h"
#include "core/input_error.h"
#include "core/interrupted.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

constexpr int kMostTries = 5;  // that each bring something

std::uint64_t size_of(const std::string& path) {
  std::error_code none;
  const std::uintmax_t bytes = fs::file_size(path, none);
  return none ? 0 : bytes;
}

void remove_file(const std::string& path) {
  std::error_code ignored;
  fs::remove(path, ignored);
}

bool fits(const std::string& path, const std::string& sha256, const WantedFile& wanted) {
  if (wanted.bytes != 0 && size_of(path) != wanted.bytes) return false;
  if (wanted.sha256.empty() || sha256 == wanted.sha256) return true;
  try {
    return !wanted.content.empty() && sha256_of_content(path) == wanted.content;
  } catch (const InputError&) {  // damaged
    return false;
  }
}

// What a server sends to people instead of data.
bool is_page(const std::string& path) {
  std::string start(512, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(file.gcount()));
  std::transform(start.begin(), start.end(), start.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const std::size_t first = start.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return false;
  const std::string_view text = std::string_view(start).substr(first);
  return text.starts_with("<!doctype html") || text.starts_with("<html");
}

// Why the bytes at `part`, all that came from the place, are not those that are wanted.
std::string objection(const std::string& part, const std::string& sha256,
                      const WantedFile& wanted) {
  const std::uint64_t bytes = size_of(part);
  if (is_page(part)) {
    return fmt::format(
        "gives an HTML page of {} bytes, for people to read or to log in, and not "
        "the file",
        bytes);
  }
  if (wanted.bytes != 0 && bytes != wanted.bytes) {
    return fmt::format("gives {} bytes, and the file has {}", bytes, wanted.bytes);
  }
  return fmt::format("gives another file: its SHA-256 is {}…, not {}…", sha256.substr(0, 12),
                     wanted.sha256.substr(0, 12));
}

[[noreturn]] void refuse_wrong(const std::string& place, const std::string& reason) {
  throw InputError({place}, reason,
                   "it was not kept; name a folder or a mirror that has the file with --from");
}

[[noreturn]] void refuse_unfinished(const std::string& place, const std::string& reason,
                                    const std::string& part, const WantedFile& wanted) {
  const std::uint64_t bytes = size_of(part);
  if (bytes == 0) {
    remove_file(part);
    throw InputError({place}, reason,
                     "try again later, or name a folder or a mirror that has the file with --from");
  }
  const std::string of_all = wanted.bytes == 0 ? "" : fmt::format(" of {}", wanted.bytes);
  throw InputError(
      {place}, reason,
      fmt::format("{}{} bytes have come and are kept: the same command goes on", bytes, of_all));
}

// The part becomes the file where it is the right one; else it is gone, with the reason.
std::string accept(const std::string& part, const WantedFile& wanted) {
  const std::string sha256 = sha256_of_file(part);
  if (!fits(part, sha256, wanted)) {
    const std::string reason = objection(part, sha256, wanted);
    remove_file(part);
    return reason;
  }
  sync_file(part);
  fs::rename(part, wanted.path);
  sync_folder(fs::path(wanted.path).parent_path().string());
  return {};
}

bool download(const std::string& address, const WantedFile& wanted, const BytesSoFar& told) {
  const std::string part = wanted.path + ".part";
  const GoesOn goes_on = [&] { return !told || told(size_of(part)); };
  for (int tries = 1;; ++tries) {
    const std::uint64_t before = size_of(part);
    if (before == 0 || before != wanted.bytes) {
      const Transfer transfer = mapbed::transfer(address, part, goes_on);
      if (transfer.end == TransferEnd::not_there) return false;
      if (transfer.end == TransferEnd::no_ranges && before > 0) {
        remove_file(part);
        continue;
      }
      const bool is_cut = transfer.end == TransferEnd::cut && size_of(part) > before;
      if (is_cut && tries < kMostTries) continue;
      if (transfer.end != TransferEnd::done) {
        refuse_unfinished(address, transfer.reason, part, wanted);
      }
    }
    if (size_of(part) == 0) {
      remove_file(part);
      refuse_wrong(address, "gives an empty file");
    }
    const std::string reason = accept(part, wanted);
    if (reason.empty()) return true;
    if (before == 0) refuse_wrong(address, reason);  // else the part was of another file
  }
}

[[noreturn]] void refuse_copy(const std::string& path) {
  throw InputError({path}, std::string("cannot be written: ") + std::strerror(errno),
                   "make room, or name another folder with --to");
}

void copy_bytes(std::ifstream& from, const std::string& part, const BytesSoFar& told) {
  std::ofstream to(part, std::ios::binary | std::ios::trunc);
  std::vector<char> piece(std::size_t{1} << 20);
  std::uint64_t bytes = 0;
  while (to && from.read(piece.data(), static_cast<std::streamsize>(piece.size())).gcount() > 0) {
    to.write(piece.data(), from.gcount());
    bytes += static_cast<std::uint64_t>(from.gcount());
    if (told && !told(bytes)) throw Interrupted();
  }
  to.close();
  if (!to) refuse_copy(part);
}

bool copy(const std::string& path, const WantedFile& wanted, const BytesSoFar& told) {
  std::error_code none;
  if (!fs::is_regular_file(path, none)) return false;
  std::ifstream from(path, std::ios::binary);
  if (!from) {
    throw InputError({path}, std::string("cannot be read: ") + std::strerror(errno),
                     "check its permissions");
  }
  const std::string part = wanted.path + ".part";
  try {
    copy_bytes(from, part, told);
  } catch (...) {
    remove_file(part);
    throw;
  }
  const std::string reason = accept(part, wanted);
  if (!reason.empty()) refuse_wrong(path, reason);
  return true;
}

}  // namespace

bool is_address(const std::string& place) {
  return place.find("://") != std::string::npos;
}

bool get_file(const std::string& place, const WantedFile& wanted, const BytesSoFar& told) {
  return is_address(place) ? download(place, wanted, told) : copy(place, wanted, told);
}

}  // namespace mapbed
