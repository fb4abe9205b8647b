#pragma once

#include <algorithm>
#include <vector>

namespace enduring {

/// Ascending, each item once.
template <class Item>
void sort_once(std::vector<Item>& items)
{
    std::sort(items.begin(), items.end());
    items.erase(std::unique(items.begin(), items.end()), items.end());
}

}  // namespace enduring
