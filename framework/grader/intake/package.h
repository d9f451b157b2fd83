#pragma once
/// \file
/// What is in a file that holds others, or stands for another: told by what it begins with, or by its name.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace muelle::grader {

/// So many of the first bytes tell what a file is.
inline constexpr std::size_t headBytes = 512;

/// The compression by the file's first bytes, as libarchive numbers it: ARCHIVE_FILTER_NONE when there is none.
int compressionOf(std::string_view bytes);

/// True when the bytes begin as one of the archives that are read: zip, 7z, tar and its compressions.
bool beginsAsArchive(std::string_view bytes);

/// True when a file is to be opened as an archive: by its suffix, or by its first bytes, since a browser may drop the
/// suffix and a student put another. A document of an office program is no archive, though a zip inside; neither is a
/// compressed file with a suffix of its own.
bool isArchive(const std::string& name, std::string_view head);

/// A file that is not what is wanted, but stands for it.
struct StandIn {
  std::string name;  ///< of what it stands for; "" when that may be anything, as in an archive that is not opened
  std::string why;   ///< "a RAR archive is not opened: hand in a folder, or a zip, tar or 7z archive"
};

/// An archive of a kind that is not opened, a part of one, a placeholder of a cloud drive, a shortcut, an unfinished
/// download; nullopt for every other file. `head`: its first bytes.
std::optional<StandIn> standIn(const std::string& name, std::string_view head);

}  // namespace muelle::grader
