#pragma once

// Bags as logs; see core/log/bags/.

namespace mapbed {

struct LogDialect;
LogDialect rosbag1_dialect();
LogDialect rosbag2_dialect();
LogDialect mcap_dialect();

}  // namespace mapbed
