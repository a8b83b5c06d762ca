#pragma once

#include <span>
#include <string>

#include "core/input_error.h"

namespace mapbed {

struct RecordedLog;

// A way of writing logs for other programs. A new one is a function and a line in the table.
struct LogFormat {
  const char* name = "";       // "carmen"
  const char* extension = "";  // ".log", of its files
  const char* about = "";
  void (*write)(const std::string& path, const RecordedLog& log) = nullptr;
  bool is_folder = false;
  bool has_rfid = false;  // it can say what an RFID reader heard
};

std::span<const LogFormat> log_formats();

// Throws InputError for an unknown name, which stands at `place`, with the nearest one.
const LogFormat& log_format_by_name(const std::string& name, const SourceLocation& place = {});

// That of files with such an ending; CARMEN's for all others. Throws InputError for .db3, which is
// a part of a bag.
const LogFormat& log_format_of_path(const std::string& path);

}  // namespace mapbed
