#pragma once

#include <string>
#include <vector>

// How files that are stored here come out of public ones.

namespace mapbed {

struct MadeFile;

struct Recipe {
  const char* name;  // under `by` of a file that is made
  const char* about;
  std::string (*make)(const std::string& piece_path, const MadeFile& made);  // all but the header
};

const std::vector<Recipe>& recipes();

// Makes the file of its piece, packed where its name ends in .gz, and writes it; packed as the
// file of the expected SHA-256 was, where that is possible. Throws InputError for a recipe that is
// not known, a piece that it cannot read, and where what comes out is not what shall be in the
// file; then nothing is written.
void make_file(const std::string& piece_path, const MadeFile& made, const std::string& expected,
               const std::string& path);

}  // namespace mapbed
