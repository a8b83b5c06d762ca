#include "bench/fetch/scan_list.h"

#include <cmath>

#include <fmt/format.h>

#include "core/input_error.h"
#include "core/log/bags/bag_file.h"
#include "core/log/log_options.h"

namespace mapbed {
namespace {

std::string range_text(double range) {
  if (!std::isfinite(range)) return "0";
  std::string text = fmt::format("{:.3f}", range);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

}  // namespace

std::string scan_list(const std::string& bag_path, std::uint64_t scans) {
  std::string text;
  std::uint64_t count = 0;
  BagLog log(bag_path, LogOptions{});
  log.watch_scans([&](const RosLaserScan& scan) {
    if (scans != 0 && count++ >= scans) return;
    text += fmt::format("{:.6f} {}", scan.header.stamp, scan.ranges.size());
    for (const double range : scan.ranges) text += ' ' + range_text(range);
    text += '\n';
  });
  (void)read_bag(bag_path, log);
  if (text.empty()) throw InputError({bag_path}, "has no scan of a laser");
  return text;
}

}  // namespace mapbed
