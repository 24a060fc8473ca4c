// The hash table: beside std::unordered_map, with keys that lie far apart and next to each other.
#include "Support/HashTable.h"

#include <gtest/gtest.h>

#include <random>
#include <unordered_map>

namespace voxc::test {
namespace {

template <typename Table> void expectSame(Table table, std::uint64_t mostKey, int questions) {
  std::unordered_map<std::uint64_t, int> other;
  std::mt19937_64 random(7);
  for (int i = 0; i < questions; ++i) {
    const auto key = static_cast<std::uint32_t>(1 + random() % mostKey);
    const auto known = other.find(key);
    const int *found = table.find(key);
    ASSERT_EQ(found ? *found : -1, known != other.end() ? known->second : -1);
    table[key] = other[key] = i;
    ASSERT_EQ(table.size(), other.size());
  }
  table.keepIf([](std::uint64_t key) { return key % 3 == 0; });
  std::size_t count = 0;
  table.forEach([&](std::uint64_t key, int value) {
    ASSERT_EQ(key % 3, 0u);
    ASSERT_EQ(value, other.at(key));
    ++count;
  });
  EXPECT_EQ(count, table.size());
  EXPECT_EQ(count, std::erase_if(other, [](const auto &entry) { return entry.first % 3 == 0; }));
  table.clear();
  EXPECT_EQ(table.size(), 0u);
  EXPECT_EQ(table.find(3), nullptr);
}

TEST(HashTable, AnswersAsTheStandardOne) {
  expectSame(HashTable<int>(), 50, 1000);
  expectSame(HashTable<int>(), 0xffffffff, 20000);
  expectSame(HashTable<int, std::uint32_t>(), 30000, 20000);
  expectSame(HashTable<int, std::uint32_t, 4>(), 3000, 20000);
}

TEST(HashTable, NewValuesAreZero) {
  HashTable<int> table;
  EXPECT_EQ(table[std::uint64_t{1} << 63], 0);
  EXPECT_EQ(table.size(), 1u);
}

} // namespace
} // namespace voxc::test
