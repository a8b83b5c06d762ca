#include "core/log/bags/bag_file.h"

#include <filesystem>
#include <fstream>
#include <system_error>

#include <fmt/format.h>

#include "core/file/file_reader.h"
#include "core/file/unpack.h"
#include "core/log/bags/bag_folder.h"
#include "core/log/bags/mcap.h"
#include "core/log/bags/rosbag1.h"
#include "core/log/bags/rosbag2.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kZstd = "\x28\xb5\x2f\xfd";

bool begins_as_bag(std::string_view bytes) {
  return Rosbag1Reader::fits(bytes) || Rosbag2Reader::fits(bytes) || McapReader::fits(bytes);
}

bool is_gzip(const std::string& path) {
  char bytes[2] = {};
  std::ifstream(path, std::ios::binary).read(bytes, sizeof bytes);
  return std::string_view(bytes, sizeof bytes) == "\x1f\x8b";
}

std::string unpacked(FileReader& file, std::string_view piece, const BagLog& log) {
  std::string packed;
  for (; !piece.empty() && packed.size() <= log.max_bytes(); piece = file.next()) packed += piece;
  Unpacked whole = unpack_zstd(packed, log.max_bytes());
  if (whole.bytes.size() < log.max_bytes()) return std::move(whole.bytes);
  throw InputError(
      {log.name()},
      fmt::format("unpacks to more than {:.0f} MB", 1e-6 * static_cast<double>(log.max_bytes())),
      "unpack it with zstd, or raise log.max_text");
}

// `next` gives the pieces that follow; the empty one is the end.
template <class Reader, class Next>
std::string read_pieces(std::string_view piece, Next&& next, BagLog& log, const GoesOn& goes_on) {
  Reader reader(log);
  for (; !piece.empty(); piece = next()) {
    throw_unless(goes_on);
    reader.add(piece);
  }
  reader.finish();
  return std::string(Reader::kFormat);
}

template <class Next>
std::string read_any(std::string_view piece, Next&& next, BagLog& log, const GoesOn& goes_on) {
  if (Rosbag1Reader::fits(piece)) return read_pieces<Rosbag1Reader>(piece, next, log, goes_on);
  if (Rosbag2Reader::fits(piece)) return read_pieces<Rosbag2Reader>(piece, next, log, goes_on);
  if (McapReader::fits(piece)) return read_pieces<McapReader>(piece, next, log, goes_on);
  throw InputError({log.name()}, "is no bag that is known here",
                   "bags of ROS 1 (2.0), of ROS 2 (.db3) and MCAP are read");
}

std::string read_file(const std::string& path, BagLog& log, const GoesOn& goes_on) {
  FileReader file(path);
  const std::string_view first = file.next();
  if (first.starts_with(kZstd)) {
    const std::string bytes = unpacked(file, first, log);
    return read_any(
        bytes, [] { return std::string_view(); }, log, goes_on);
  }
  if (Rosbag2Reader::fits(first) && !is_gzip(path)) {
    read_rosbag2_file(path, log, goes_on);
    return std::string(Rosbag2Reader::kFormat);
  }
  return read_any(
      first, [&] { return file.next(); }, log, goes_on);
}

// One that is broken from its beginning on, as a recorder leaves it that was killed, does not hide
// the others, and has no format.
std::string read_part(const std::string& path, bool is_only_one, BagLog& log,
                      const GoesOn& goes_on) {
  const long before = log.messages();
  log.begin_part(path);
  try {
    return read_file(path, log, goes_on);
  } catch (const InputError& error) {
    if (is_only_one || log.messages() > before) throw;
    log.remark("a part of it cannot be read", fmt::format(", {}", error.what()));
    return {};
  }
}

}  // namespace

bool is_bag(const std::string& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return !bag_folder(path).files.empty();
  if (!fs::is_regular_file(path, ignored)) return false;
  FileReader file(path);
  const std::string_view first = file.next();
  return begins_as_bag(first) || first.starts_with(kZstd);
}

std::string read_bag(const std::string& path, BagLog& log, const GoesOn& goes_on) {
  if (!fs::is_directory(path)) return read_file(path, log, goes_on);
  const BagFolder folder = bag_folder(path);
  if (!folder.remark.empty()) log.remark(folder.remark);
  std::string format;
  for (const std::string& file : folder.files) {
    const std::string part = read_part(file, folder.files.size() == 1, log, goes_on);
    if (!part.empty()) format = part;
  }
  log.end_parts();
  return format;
}

}  // namespace mapbed
