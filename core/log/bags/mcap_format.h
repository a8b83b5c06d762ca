#pragma once

#include <cstdint>

namespace mapbed {

// What a record of an MCAP file is, as its first byte tells. Attachments (9, 10) and metadata
// (12, 13) are neither read nor written.
enum class McapRecord : std::uint8_t {
  header = 1,
  footer = 2,
  schema = 3,
  channel = 4,
  message = 5,
  chunk = 6,
  message_index = 7,
  chunk_index = 8,
  statistics = 11,
  summary_offset = 14,
  data_end = 15
};

}  // namespace mapbed
