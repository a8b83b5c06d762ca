#include "bench/process/provenance.h"

#include <ctime>
#include <fstream>

#include <nlohmann/json.hpp>
#include <sys/utsname.h>
#include <unistd.h>

#include "bench/process/version.h"
#include "core/file/hash.h"
#include "core/file/utf8.h"

namespace mapbed {
namespace {

using Json = nlohmann::ordered_json;

// "Intel(R) Xeon(R) …" as Linux names it; empty where it does not.
std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return {};
}

bool has_fused_multiply_add() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("fma") != 0;
#else
  return true;
#endif
}

std::string now_utc() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  std::string text(20, ' ');
  std::strftime(text.data(), text.size() + 1, "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text;
}

Json machine() {
  utsname system{};
  uname(&system);
  const double pages = static_cast<double>(sysconf(_SC_PHYS_PAGES));
  return {{"processor", processor_name()},
          {"fused_multiply_add", has_fused_multiply_add()},  // the promise of equal bytes ends here
          {"cores", sysconf(_SC_NPROCESSORS_ONLN)},
          {"memory_bytes", pages * static_cast<double>(sysconf(_SC_PAGESIZE))},
          {"system", std::string(system.sysname) + " " + system.release + " " + system.machine}};
}

}  // namespace

std::string to_json(const Provenance& p) {
  Json libraries = Json::object();
  for (const LibraryVersion& library : version().libraries) {
    libraries[library.name] = library.version;
  }
  Json command = Json::array();
  for (const std::string& word : p.command) command.push_back(escaped_utf8(word));
  Json tables = Json::object();
  for (const auto& [name, checksum] : p.tables_sha256) tables[name] = checksum;
  const Json json{{"program",
                   {{"version", version().program},
                    {"revision", version().revision},
                    {"compiler", version().compiler},
                    {"build", version().build},
                    {"sha256", p.program_sha256},
                    {"libraries", libraries}}},
                  {"machine", machine()},
                  {"command", command},
                  {"seed", p.seed},
                  {"runs_sha256", p.runs_sha256},
                  {"runs", p.runs},
                  {"runs_done_before", p.runs_done_before},
                  {"recordings_needed", p.recordings_needed},
                  {"recordings_made", p.recordings_made},
                  {"threads", p.threads},
                  {"wall_seconds", p.wall_seconds},
                  {"processor_seconds", p.processor_seconds},
                  {"tables_sha256", tables},
                  {"finished", now_utc()}};
  return json.dump(2) + "\n";
}

std::string sha256_of_program() {
  static const std::string digits = sha256_of_file("/proc/self/exe");
  return digits;
}

}  // namespace mapbed
