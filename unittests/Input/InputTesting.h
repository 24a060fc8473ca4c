// What tests of inputs share: an input that is opened, with all that it says, and bytes that gzip made.
#pragma once

#include "Source/SourceTesting.h"

#include "voxc/Input/Input.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <string>
#include <vector>

namespace voxc {

/// Opens inputs with `options_`, and keeps what the last one said.
class OpenedInputs : public testing::Test {
protected:
  /// The voxels of an input that opens; none, and a failure, if it does not.
  Voxels take(const Expected<Input> &input) {
    EXPECT_TRUE(input) << (input ? "" : input.error().message);
    if (!input)
      return {};
    warnings_ = input->warnings;
    notes_ = input->notes;
    files_ = input->files;
    provenance_ = input->provenance;
    extent_ = input->source->extent();
    map_ = input->source->voxelToModel();
    return voxelsOf(*input->source);
  }
  Voxels voxels(const std::string &name, const std::string &content) {
    return take(openInput(folder_.file(name, content), options_));
  }

  /// The words of a file that is there, x fastest.
  std::vector<std::uint32_t> words(const std::string &name) {
    const Voxels found = take(openInput(folder_.path(name), options_));
    std::vector<std::uint32_t> words(static_cast<std::size_t>(extent_.x * extent_.y * extent_.z));
    for (const auto &[code, word] : found) {
      const Int3 cell = mortonCell(code);
      words[static_cast<std::size_t>((cell.z * extent_.y + cell.y) * extent_.x + cell.x)] = word;
    }
    return words;
  }
  std::vector<std::uint32_t> words(const std::string &name, const std::string &content) {
    folder_.file(name, content);
    return words(name);
  }

  /// The message of an error; "none" if there is none.
  std::string problem(const std::string &name) {
    const auto input = openInput(folder_.path(name), options_);
    return input ? "none" : input.error().message;
  }
  std::string problem(const std::string &name, const std::string &content) {
    folder_.file(name, content);
    return problem(name);
  }

  TemporaryFolder folder_;
  InputOptions options_;
  std::vector<std::string> warnings_, notes_, files_;
  std::string provenance_;
  Int3 extent_;
  Transform map_;
};

inline std::string gzipped(const std::string &bytes) {
  z_stream stream{};
  EXPECT_EQ(deflateInit2(&stream, 9, Z_DEFLATED, 16 + MAX_WBITS, 8, Z_DEFAULT_STRATEGY), Z_OK);
  std::string out(deflateBound(&stream, bytes.size()) + 64, '\0');
  stream.next_in = reinterpret_cast<Bytef *>(const_cast<char *>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef *>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  out.resize(out.size() - stream.avail_out);
  deflateEnd(&stream);
  return out;
}

} // namespace voxc
