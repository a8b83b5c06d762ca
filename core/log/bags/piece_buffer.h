#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace mapbed {

// Joins pieces that are cut anywhere into one after the other of what a reader takes off the front.
class PieceBuffer {
 public:
  // `take(bytes)` returns how many of them it needs no more; it gets the others again, with those
  // that follow. A piece is copied only where something of it is left.
  template <class Take>
  void add(std::string_view piece, Take&& take) {
    if (rest_.empty()) {
      const std::size_t used = take(piece);
      rest_.assign(piece.substr(used));
      return;
    }
    rest_ += piece;
    if (rest_.size() < wanted_) return;
    rest_.erase(0, take(std::string_view(rest_)));
  }

  // take() has nothing to do before so many bytes are there; until it says otherwise.
  void want(std::size_t bytes) { wanted_ = bytes; }
  std::string_view rest() const { return rest_; }

 private:
  std::string rest_;
  std::size_t wanted_ = 0;
};

}  // namespace mapbed
