#include "core/log/dialects/dialects.h"

#include "core/log/dialects/bag.h"
#include "core/log/dialects/carmen_log.h"
#include "core/log/dialects/coreslam_log.h"
#include "core/log/dialects/dpslam_log.h"
#include "core/log/dialects/scan_list_log.h"

namespace mapbed {

std::span<const LogDialect> log_dialects() {
  static const LogDialect dialects[] = {
      dpslam_dialect(),  carmen_dialect(),  scan_list_dialect(), coreslam_dialect(),
      rosbag1_dialect(), rosbag2_dialect(), mcap_dialect(),
  };
  return dialects;
}

void refuse_unknown_text(const std::string& name) {
  std::string known;
  for (const LogDialect& dialect : log_dialects())
    known += (known.empty() ? "" : ", ") + std::string(dialect.name);
  throw InputError({name}, "is in no log format that is known here", "known are " + known);
}

}  // namespace mapbed
