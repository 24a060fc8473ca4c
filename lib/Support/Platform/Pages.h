// Addresses that are reserved, and pages of memory that come to lie there. Sizes and offsets are whole pages;
// what fails says why by `errno`.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

namespace voxc::platform {

std::uint64_t pageBytes();

/// Addresses where nothing is yet; null if there are not so many.
std::byte *reserve(std::uint64_t bytes);
/// Gives them back with all that lies there.
void release(std::byte *at, std::uint64_t bytes);
/// The most addresses that a limit allows this process, if there is one.
std::optional<std::uint64_t> mostAddresses();

/// Zeroed memory at reserved addresses.
bool addMemory(std::byte *at, std::uint64_t bytes);

/// In place of memory, what was just written to an open file at `offset`: from now on it can only be read.
/// Where the system cannot do that, it stays memory.
bool replaceByFile(std::byte *at, std::uint64_t bytes, int file, std::uint64_t offset);

/// Memory of which there are several mappings, at most so many bytes: a number of it, or -1. It begins with
/// nothing.
int openShared(std::uint64_t most);
void closeShared(int shared);
/// Addresses for all of it.
std::byte *reserveShared(int shared, std::uint64_t most);
/// Adds zeroed bytes to such memory, which had `offset` so far, and maps them behind those at `begin`.
bool addShared(std::byte *begin, std::uint64_t bytes, int shared, std::uint64_t offset);
/// The first bytes of such memory at other addresses. What is written there is seen there alone.
std::byte *viewShared(int shared, std::uint64_t bytes);

} // namespace voxc::platform
