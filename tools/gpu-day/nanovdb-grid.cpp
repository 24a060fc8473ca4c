// nanovdb-grid FILE.nvdb GRID.bin: the first grid of a file as it lies in memory, which is what nanovdb.cu
// reads.
#include <nanovdb/util/IO.h>

#include <fstream>

int main(int count, char **arguments) {
  if (count != 3)
    return 2;
  const auto grid = nanovdb::io::readGrid(arguments[1]);
  std::ofstream file(arguments[2], std::ios::binary);
  file.write(reinterpret_cast<const char *>(grid.data()), static_cast<std::streamsize>(grid.size()));
  return file.flush() ? 0 : 1;
}
