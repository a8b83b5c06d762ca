#include "algorithms/pose_graph/fronts/front_structure.h"

#include <algorithm>

#include "algorithms/pose_graph/elimination_order.h"

namespace mapbed {
namespace {

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

// Rows below the diagonal of each column of the factor: its own and those of its children.
std::vector<std::vector<int>> rows_below(const std::vector<int>& tree,
                                         const std::vector<std::pair<int, int>>& pairs) {
  std::vector<std::vector<int>> below(tree.size());
  for (const auto& [a, b] : pairs) {
    if (a != b) below[index(std::min(a, b))].push_back(std::max(a, b));
  }
  std::vector<int> seen_by(tree.size(), -1);
  std::vector<int> last_child(tree.size(), -1), earlier_child(tree.size(), -1);
  for (int column = 0; column < static_cast<int>(tree.size()); ++column) {
    std::vector<int>& own = below[index(column)];
    std::size_t kept = 0;
    const auto take = [&](int row) {
      if (row == column || seen_by[index(row)] == column) return false;
      seen_by[index(row)] = column;
      return true;
    };
    for (const int row : own) {
      if (take(row)) own[kept++] = row;
    }
    own.resize(kept);
    for (int child = last_child[index(column)]; child != -1; child = earlier_child[index(child)]) {
      for (const int row : below[index(child)]) {
        if (take(row)) own.push_back(row);
      }
    }
    if (const int parent = tree[index(column)]; parent != -1) {
      earlier_child[index(column)] = last_child[index(parent)];
      last_child[index(parent)] = column;
    }
  }
  return below;
}

// Columns that are to be one front, and how many blocks of it hold something.
struct Group {
  int first = 0, last = 0;
  std::size_t below = 0;
  std::size_t filled = 0;

  std::size_t columns() const { return index(last - first + 1); }
};

std::size_t blocks_of(std::size_t columns, std::size_t below) {
  return columns * (columns + 1) / 2 + columns * below;
}

// One front of two, where it has few zeros for its size.
bool are_worth_joining(const Group& child, const Group& parent) {
  const std::size_t columns = child.columns() + parent.columns();
  const auto all = static_cast<double>(blocks_of(columns, parent.below));
  const double zeros = all - static_cast<double>(child.filled + parent.filled);
  return zeros < all * (columns <= 4 ? 0.4 : columns <= 16 ? 0.15 : 0.05);
}

std::vector<Group> grouped(const std::vector<int>& tree,
                           const std::vector<std::vector<int>>& below) {
  std::vector<Group> groups;
  for (int column = 0; column < static_cast<int>(tree.size()); ++column) {
    const std::size_t rows = below[index(column)].size();
    if (!groups.empty() && tree[index(groups.back().last)] == column &&
        groups.back().below == rows + 1) {
      Group& group = groups.back();
      group.last = column;
      group.below = rows;
      group.filled += rows + 1;
    } else {
      groups.push_back({column, column, rows, rows + 1});
    }
  }
  std::vector<Group> joined;
  for (Group group : groups) {
    while (!joined.empty()) {
      const Group& child = joined.back();
      const int parent = tree[index(child.last)];
      if (parent < group.first || parent > group.last || !are_worth_joining(child, group)) break;
      group.first = child.first;
      group.filled += child.filled;
      joined.pop_back();
    }
    joined.push_back(group);
  }
  return joined;
}

}  // namespace

int Front::row_of(int place) const {
  if (place < first + columns) return place - first;
  return columns +
         static_cast<int>(std::lower_bound(below.begin(), below.end(), place) - below.begin());
}

FrontStructure::FrontStructure(int unknowns, const std::vector<std::pair<int, int>>& pairs)
    : places(elimination_places(unknowns, pairs)), front_of(index(unknowns)) {
  std::vector<std::pair<int, int>> placed = pairs;
  const auto place = [&](const std::vector<int>& at) {
    for (auto& [a, b] : placed) {
      a = at[index(a)];
      b = at[index(b)];
    }
  };
  place(places);
  const std::vector<int> later = postorder(elimination_tree(unknowns, placed));
  place(later);
  for (int& p : places) p = later[index(p)];

  const std::vector<int> tree = elimination_tree(unknowns, placed);
  std::vector<std::vector<int>> below = rows_below(tree, placed);
  for (const Group& group : grouped(tree, below)) {
    for (int column = group.first; column <= group.last; ++column) {
      front_of[index(column)] = static_cast<int>(fronts.size());
    }
    Front front{.first = group.first, .columns = group.last - group.first + 1};
    front.below = std::move(below[index(group.last)]);
    std::sort(front.below.begin(), front.below.end());
    fronts.push_back(std::move(front));
  }
  for (Front& front : fronts) {
    if (front.below.empty()) continue;
    front.parent = front_of[index(front.below.front())];
    const Front& parent = fronts[index(front.parent)];
    for (const int row : front.below) front.in_parent.push_back(parent.row_of(row));
  }
}

}  // namespace mapbed
