#include "bench/fetch/testing/local_server.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <string_view>
#include <utility>

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "core/check.h"

namespace mapbed {
namespace {

std::string request_from(int connection) {
  std::string request;
  char piece[1024];
  while (request.find("\r\n\r\n") == std::string::npos) {
    const ssize_t bytes = recv(connection, piece, sizeof piece, 0);
    if (bytes <= 0) break;
    request.append(piece, static_cast<std::size_t>(bytes));
  }
  return request;
}

std::string between(const std::string& text, const std::string& before, char after) {
  const std::size_t start = text.find(before);
  if (start == std::string::npos) return {};
  const std::size_t from = start + before.size();
  return text.substr(from, text.find(after, from) - from);
}

void send_all(int connection, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = send(connection, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent <= 0) return;
    bytes.remove_prefix(static_cast<std::size_t>(sent));
  }
}

}  // namespace

LocalServer::LocalServer() : socket_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof place;
  auto* const address = reinterpret_cast<sockaddr*>(&place);
  CHECK(bind(socket_, address, size) == 0 && listen(socket_, 8) == 0);
  CHECK(getsockname(socket_, address, &size) == 0);
  port_ = ntohs(place.sin_port);
  setenv("no_proxy", "*", 1);  // whatever the machine has for the world outside
  thread_ = std::thread([this] { serve(); });
}

LocalServer::~LocalServer() {
  ended_ = true;
  shutdown(socket_, SHUT_RDWR);
  thread_.join();
  close(socket_);
}

void LocalServer::put(const std::string& name, Answer answer) {
  const std::scoped_lock lock(mutex_);
  answers_[name] = std::move(answer);
}

std::string LocalServer::address(const std::string& name) const {
  return fmt::format("http://127.0.0.1:{}/{}", port_, name);
}

std::vector<std::string> LocalServer::requests() const {
  const std::scoped_lock lock(mutex_);
  return requests_;
}

void LocalServer::serve() {
  while (!ended_) {
    const int connection = accept(socket_, nullptr, nullptr);
    if (connection < 0) continue;
    answer(connection);
    close(connection);
  }
}

void LocalServer::answer(int connection) {
  const std::string request = request_from(connection);
  const std::string name = between(request, "GET /", ' ');
  const std::string from = between(request, "Range: bytes=", '-');
  Answer answer{.bytes = "nothing", .status = 404};
  {
    const std::scoped_lock lock(mutex_);
    requests_.push_back(from.empty() ? name : name + " from " + from);
    const auto found = answers_.find(name);
    if (found != answers_.end()) answer = found->second;
  }
  std::size_t start = 0;
  std::string headers;
  if (!answer.redirect.empty()) {
    answer.status = 302;
    headers = "Location: " + answer.redirect + "\r\n";
  } else if (!from.empty() && answer.has_ranges && answer.status == 200) {
    start = std::stoul(from);
    answer.status = start < answer.bytes.size() ? 206 : 416;
    start = std::min(start, answer.bytes.size());
    headers = fmt::format("Content-Range: bytes {}-{}/{}\r\n", start, answer.bytes.size() - 1,
                          answer.bytes.size());
  }
  const std::string_view rest = std::string_view(answer.bytes).substr(start);
  send_all(connection, fmt::format("HTTP/1.1 {} x\r\nContent-Length: {}\r\nConnection: close\r\n{}"
                                   "\r\n",
                                   answer.status, rest.size(), headers));
  send_all(connection, rest.substr(0, answer.most));
  while (answer.stalls && !ended_) std::this_thread::sleep_for(std::chrono::milliseconds(2));
}

}  // namespace mapbed
