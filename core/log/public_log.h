#pragma once

#include <cstdint>
#include <string>
#include <vector>

// Where the files of a log lie in public, and how they are made of what lies there. It stands
// beside the log's description, in public/ under the same name, for results rest on that one: an
// address that changes makes no result another.
//
//   cite: …                            how the authors want to be named
//   pieces:                            files of other people, as they lie there
//     - file: intel-corrected.log.gz
//       addresses: [https://…]         tried in this order
//       opened: 2026-11                when it was last got from there, or never
//       bytes: 448366                  none: unknown, as the checksum
//       sha256: 5a…
//   made:
//     - file: intel/intel_910_rawodom.clf.gz   as the description calls it
//       content: 7e…                   SHA-256 of what it unpacks to
//       piece: intel-corrected.log.gz
//       by: chained_odometry           bench/fetch/recipes.h
//       header: [ … ]                  lines in front
//       start: 976052857.337284 s      added to all stamps
//       host: intel                    in each line
//       scans: 278                     of a bag, the first ones; none: all
//   by_hand: [ … ]                     the steps to files that are not made

namespace mapbed {

class ConfigNode;

struct PublicFile {
  std::string file;                    // a plain name
  std::vector<std::string> addresses;  // one at least
  std::string opened;
  std::uint64_t bytes = 0;  // 0: unknown
  std::string sha256;       // empty: unknown
};

struct MadeFile {
  std::string file;
  std::string content;
  std::string piece;  // one of the public files
  std::string by;
  std::vector<std::string> header;
  double start = 0.0;           // [s]
  std::string host = "nohost";  // CARMEN's word for none
  std::uint64_t scans = 0;      // 0: all
};

struct PublicLog {
  std::string cite;
  std::vector<PublicFile> pieces;
  std::vector<MadeFile> made;
  std::vector<std::string> by_hand;

  const MadeFile* making(const std::string& file) const;  // null: it is not made
  const PublicFile& piece_of(const MadeFile& made) const;
};

// Of the log that this file describes; empty where nothing stands in public/. Throws InputError.
PublicLog load_public_log(const std::string& description_path);

// A SHA-256; throws InputError where the value is none.
const std::string& checksum_of(const ConfigNode& node);

}  // namespace mapbed
