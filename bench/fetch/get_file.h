#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace mapbed {

// A file that shall lie at `path`, and how it is known to be the right one.
struct WantedFile {
  std::string path;
  std::uint64_t bytes = 0;   // 0: unknown
  std::string sha256 = {};   // empty: unknown
  std::string content = {};  // SHA-256 of what it unpacks to, which does as well; empty: unknown
};

// Told how many bytes of the file have come; false ends it.
using BytesSoFar = std::function<bool(std::uint64_t bytes)>;

bool is_address(const std::string& place);  // and not the path of a file

// Gets it from an address (http, https) or a path, into `path`.part first, which becomes `path`
// when it is whole and right. An address that ends half-way leaves that part, and the next call
// goes on from there; where the server gives no second half alone, it begins anew. Returns false
// where nothing lies at that place. Throws InputError, with what is wrong and how to go on, and
// Interrupted.
bool get_file(const std::string& place, const WantedFile& wanted, const BytesSoFar& told = {});

}  // namespace mapbed
