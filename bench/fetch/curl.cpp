#include "bench/fetch/curl.h"

#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "bench/process/child_process.h"
#include "core/file/tokens.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

constexpr const char* kStatus = "mapbed-http-status ";  // before the number, in what curl prints

// A server may send from one address to another, but not from a safe one to an open one.
std::vector<std::string> words_for(const std::string& address, const std::string& part) {
  const bool is_safe = address.starts_with("https:");
  return {"curl",
          "-q",  // the user's own settings may say anything
          "--globoff",
          "--no-buffer",  // what has come is in the file, for who is interrupted
          "--silent",
          "--show-error",
          "--fail",
          "--location",
          "--max-redirs",
          "10",
          "--proto",
          "=http,https",
          "--proto-redir",
          is_safe ? "=https" : "=http,https",
          "--connect-timeout",
          "20",
          "--speed-limit",  // [bytes/s]
          "100",
          "--speed-time",  // [s]
          "60",
          "--continue-at",
          "-",
          "--output",
          part,
          "--write-out",
          fmt::format("\n{}%{{http_code}}\n", kStatus),
          "--url",
          address};
}

struct Words {
  int http_status = 0;
  std::string last;  // "Could not resolve host: …", without "curl: (6) "
};

Words words_in_messages(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string all{std::istreambuf_iterator<char>(file), {}};
  Words words;
  for (std::string_view rest = all; !rest.empty();) {
    std::string_view line = next_line(rest);
    if (line.starts_with(kStatus)) {
      (void)parse_number(line.substr(std::string_view(kStatus).size()), words.http_status);
    } else if (const auto end = line.find(") "); line.starts_with("curl: (") && end < line.size()) {
      words.last = line.substr(end + 2);
    }
  }
  return words;
}

// By the exit status of curl, as its manual has them.
Transfer result_of(const ChildEnd& end, const Words& words) {
  using enum TransferEnd;
  if (end.is_success()) return {done, ""};
  if (end.error != 0 || end.signal != 0) return {failed, "curl " + text_of(end, 0.0)};
  static const std::map<int, Transfer> known{
      {3, {failed, "is no address"}},
      {6, {failed, "the host was not found (no network?)"}},
      {7, {failed, "the host does not answer (no network?)"}},
      {18, {cut, "the connection ended half-way"}},
      {23, {failed, "what comes cannot be written (disk full?)"}},
      {28, {cut, "nothing comes any more"}},
      {33, {no_ranges, "the server gives no second half alone"}},
      {47, {failed, "sends from one address to the next without an end"}},
      {52, {cut, "the connection ended without an answer"}},
      {56, {cut, "the connection broke"}},
      {92, {cut, "the connection broke"}}};
  if (end.status == 22) {
    if (words.http_status == 404 || words.http_status == 410) return {not_there, "is not there"};
    if (words.http_status == 416) return {no_ranges, "the server gives no second half alone"};
    return {failed, fmt::format("the server answers with status {}", words.http_status)};
  }
  const auto found = known.find(end.status);
  if (found != known.end()) return found->second;
  return {failed, fmt::format("curl ended with status {}: {}", end.status, in_quotes(words.last))};
}

}  // namespace

Transfer transfer(const std::string& address, const std::string& part, const GoesOn& goes_on) {
  if (program_in_path("curl").empty()) {
    throw InputError({address}, "is fetched by the program curl, which is not here",
                     "apt-get install curl, or get the file by other means and name its folder "
                     "with --from");
  }
  const fs::path path = fs::absolute(part);
  const std::string messages = path.string() + ".messages";
  const auto end_of = [&] {
    return run_child({words_for(address, path.string()), path.parent_path().string(), messages},
                     goes_on);
  };
  std::optional<ChildEnd> end;
  try {
    end = end_of();
  } catch (const Interrupted&) {
    fs::remove(messages);
    throw;
  }
  const Transfer result = result_of(*end, words_in_messages(messages));
  fs::remove(messages);
  return result;
}

std::string address_below(const std::string& base, const std::string& name) {
  std::string address = base.ends_with('/') ? base : base + '/';
  for (const char c : name) {
    const bool is_plain = std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                          std::string_view("/-._~").find(c) != std::string_view::npos;
    if (is_plain) {
      address += c;
    } else {
      address += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
  }
  return address;
}

}  // namespace mapbed
