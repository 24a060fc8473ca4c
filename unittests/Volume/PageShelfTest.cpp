// Pages that one tracer puts down and another takes.
#include "voxc/Volume/PageShelf.h"

#include <gtest/gtest.h>

#include <thread>

namespace voxc {
namespace {

std::vector<std::byte> page(int value, std::size_t bytes = 16) {
  return std::vector<std::byte>(bytes, std::byte(value));
}

bool has(PageShelf &shelf, std::uint32_t number, int value, std::size_t bytes = 16) {
  std::vector<std::byte> room(bytes);
  return shelf.take(number, room) && room == page(value, bytes);
}

TEST(PageShelf, KeepsWhatWasPut) {
  PageShelf shelf(64);
  EXPECT_FALSE(has(shelf, 3, 30));
  shelf.put(3, page(30));
  shelf.put(4, page(40));
  EXPECT_TRUE(has(shelf, 3, 30));
  EXPECT_TRUE(has(shelf, 3, 30));
  EXPECT_TRUE(has(shelf, 4, 40));
  EXPECT_EQ(shelf.bytes(), 32);
  shelf.put(4, page(41)); // Pages do not change.
  EXPECT_TRUE(has(shelf, 4, 40));
  EXPECT_EQ(shelf.bytes(), 32);
}

TEST(PageShelf, LetsGoWhatWasNotTakenForLongest) {
  PageShelf shelf(50);
  for (int i = 0; i < 3; ++i)
    shelf.put(i, page(i));
  EXPECT_TRUE(has(shelf, 0, 0));
  shelf.put(3, page(3));
  EXPECT_FALSE(has(shelf, 1, 1));
  for (const int stays : {0, 2, 3})
    EXPECT_TRUE(has(shelf, stays, stays)) << stays;
  EXPECT_EQ(shelf.bytes(), 48);
}

TEST(PageShelf, TakesNoPageThatIsLargerThanIt) {
  PageShelf shelf(15);
  shelf.put(1, page(1));
  EXPECT_FALSE(has(shelf, 1, 1));
  EXPECT_EQ(shelf.bytes(), 0);
}

TEST(PageShelf, GivesNoPageOfAnotherSize) {
  PageShelf shelf(64);
  shelf.put(1, page(1));
  EXPECT_FALSE(has(shelf, 1, 1, 8));
  EXPECT_FALSE(has(shelf, 1, 1, 17));
}

/// Each page is whole, whoever takes it meanwhile.
TEST(PageShelf, IsUsedByManyThreads) {
  PageShelf shelf(8 * 256);
  std::vector<std::jthread> threads;
  for (int thread = 0; thread < 4; ++thread)
    threads.emplace_back([&shelf, thread] {
      for (int i = 0; i < 2000; ++i) {
        const int number = (7 * i + thread) % 32;
        if (thread % 2 == 0)
          shelf.put(number, page(number, 256));
        std::vector<std::byte> room(256);
        if (shelf.take(number, room)) {
          EXPECT_EQ(room, page(number, 256));
        }
      }
    });
  threads.clear();
  EXPECT_LE(shelf.bytes(), 8 * 256);
}

} // namespace
} // namespace voxc
