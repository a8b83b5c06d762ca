#include "core/log/public_log.h"

#include <algorithm>
#include <filesystem>

#include "core/check.h"
#include "core/config/config_node.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

void check_address(const ConfigNode& node) {
  for (const char* scheme : {"https://", "http://"}) {
    if (node.text().starts_with(scheme)) return;
  }
  throw InputError(node.place(), in_quotes(node.text()) + " is no address of a public file",
                   "it begins with https:// or http://");
}

PublicFile public_file_of(const ConfigNode& node) {
  PublicFile piece;
  piece.file = node.at("file").text();
  if (fs::path(piece.file).filename() != piece.file || piece.file == "..") {
    throw InputError(node.at("file").place(), "a piece has a plain name, without folders",
                     "its folder stands in the address");
  }
  for (const ConfigNode& address : node.at("addresses").items()) {
    check_address(address);
    piece.addresses.push_back(address.text());
  }
  if (piece.addresses.empty()) {
    throw InputError(node.at("addresses").place(), "a piece has an address",
                     "what has none is got by hand");
  }
  piece.opened = node.at("opened").text();
  if (const ConfigNode* bytes = node.find("bytes")) piece.bytes = bytes->unsigned_number();
  if (const ConfigNode* sha256 = node.find("sha256")) piece.sha256 = checksum_of(*sha256);
  return piece;
}

MadeFile made_file_of(const ConfigNode& node, const PublicLog& log) {
  MadeFile made;
  made.file = node.at("file").text();
  made.content = checksum_of(node.at("content"));
  made.piece = node.at("piece").text();
  made.by = node.at("by").text();
  if (const ConfigNode* header = node.find("header")) made.header = header->texts();
  if (const ConfigNode* start = node.find("start")) made.start = start->number(Unit::second);
  if (const ConfigNode* host = node.find("host")) made.host = host->text();
  if (const ConfigNode* scans = node.find("scans")) made.scans = scans->unsigned_number();
  const bool is_known =
      std::any_of(log.pieces.begin(), log.pieces.end(),
                  [&made](const PublicFile& piece) { return piece.file == made.piece; });
  if (is_known) return made;
  throw InputError(node.at("piece").place(), "there is no piece " + in_quotes(made.piece),
                   "list it under 'pieces'");
}

}  // namespace

const std::string& checksum_of(const ConfigNode& node) {
  const std::string& text = node.text();
  if (text.size() == 64 && text.find_first_not_of("0123456789abcdef") == std::string::npos) {
    return text;
  }
  throw InputError(node.place(), "a SHA-256 has 64 hexadecimal digits, a to f small",
                   "sha256sum prints it");
}

const MadeFile* PublicLog::making(const std::string& file) const {
  const auto found = std::find_if(made.begin(), made.end(),
                                  [&file](const MadeFile& one) { return one.file == file; });
  return found == made.end() ? nullptr : &*found;
}

const PublicFile& PublicLog::piece_of(const MadeFile& one) const {
  const auto found = std::find_if(pieces.begin(), pieces.end(), [&one](const PublicFile& piece) {
    return piece.file == one.piece;
  });
  CHECK(found != pieces.end());
  return *found;
}

PublicLog load_public_log(const std::string& description_path) {
  const fs::path description = description_path;
  const fs::path path = description.parent_path() / "public" / description.filename();
  PublicLog log;
  std::error_code none;
  if (!fs::is_regular_file(path, none)) return log;
  const ConfigNode file = load_config(path.string());
  if (const ConfigNode* cite = file.find("cite")) log.cite = cite->text();
  if (const ConfigNode* pieces = file.find("pieces")) {
    for (const ConfigNode& piece : pieces->items()) log.pieces.push_back(public_file_of(piece));
  }
  if (const ConfigNode* made = file.find("made")) {
    for (const ConfigNode& one : made->items()) log.made.push_back(made_file_of(one, log));
  }
  if (const ConfigNode* by_hand = file.find("by_hand")) log.by_hand = by_hand->texts();
  file.check_all_used("public log");
  return log;
}

}  // namespace mapbed
