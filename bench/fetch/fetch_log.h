#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace mapbed {

struct LogDescription;
struct StoredFile;

struct FetchOptions {
  std::string folder;  // where logs are stored, as MAPBED_DATA names it
  std::string from;    // a folder or an address that has the files; empty: their public addresses
  bool force = false;  // what lies in the place of a file, and is another one, may go
};

struct FetchListener {
  std::function<void(const std::string& line)> say;
  // How much of a file has come, [bytes]; 0 in all: unknown. False ends it.
  std::function<bool(const std::string& file, std::uint64_t so_far, std::uint64_t all)> goes_on;
};

enum class Presence { missing, here, another };  // another: a file that is not the described one

// Of a file in the folder, by its checksum.
Presence presence_of(const StoredFile& stored, const LogDescription& log,
                     const std::string& folder);

// Brings all files of a log into the folder: finished from `from`, or made of its public files, or
// says the steps that people must take. Throws InputError where some are not there in the end, and
// Interrupted.
void fetch_log(const LogDescription& log, const FetchOptions& options,
               const FetchListener& listener);

}  // namespace mapbed
