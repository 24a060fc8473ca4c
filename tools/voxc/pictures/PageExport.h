// A volume as a page for browsers: its options, and what is measured for it.
#pragma once

#include "common/ClipOptions.h"
#include "common/CommandLine.h"
#include "common/PictureOptions.h"
#include "page/Page.h"
#include "tracing/Tracing.h"
#include "voxc/Volume/Volume.h"

#include <string>

namespace voxc::tool {

/// True of a file that is written as a page, by its ending.
bool isPage(const std::string &path);

class PageExport {
public:
  /// Adds --title, --url, --device-memory, what says where a picture is taken from, --sun and cuts to a
  /// command.
  void declare(const CommandLine &command);

  /// Looks at the options before any work. Errors: `Usage`, as of pictures, or options of a page for what is
  /// none.
  Expected<void> check(const std::string &path) const;

  /// Writes the page to `path`. `source` is the file of the volume, after which the page is named if nobody
  /// says how. Errors: those of tracing and of files; more words than a browser keeps.
  Expected<void> write(const Volume &volume, const std::string &source, const std::string &path,
                       const Progress &progress, Json &figures);

private:
  bool isGiven() const;
  Expected<void> stream(const Volume &volume, const std::string &source, page::PageContents &contents) const;

  std::string title_;
  std::string url_;
  std::string budget_;
  PictureOptions picture_;
  ClipOptions clip_;
};

} // namespace voxc::tool
