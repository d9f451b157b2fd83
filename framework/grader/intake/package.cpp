#include "grader/intake/package.h"

#include "grader/intake/file_names.h"

#include <archive.h>
#include <fmt/format.h>
#include <algorithm>
#include <array>

namespace muelle::grader {

namespace {

constexpr const char* handInOther = "hand in a folder, or a zip, tar or 7z archive";
constexpr const char* placeholder = "a placeholder: the file itself was never downloaded; download it and hand that in";
constexpr const char* shortcut = "a shortcut: hand in the file itself";
constexpr const char* unfinished = "a download that did not end: hand in the whole file";
constexpr const char* packedAlone = "a compressed file alone is not opened: hand in the file itself";

constexpr std::array<std::string_view, 24> documents{
    ".docx", ".docm", ".dotx", ".xlsx", ".xlsm", ".pptx", ".pptm", ".odt",     ".ods", ".odp", ".odg",  ".pages",
    ".key",  ".epub", ".jar",  ".whl",  ".apk",  ".npz",  ".mlx",  ".numbers", ".ggb", ".kmz", ".xopp", ".vsdx"};

struct Kind {
  std::string_view mark;
  std::size_t offset;
  const char* name;
};
constexpr std::array<Kind, 9> unopenedContents{{{"Rar!\x1a\x07", 0, "RAR"},
                                                {"-lh", 2, "LHA"},
                                                {"\x60\xea", 0, "ARJ"},
                                                {"MSCF", 0, "CAB"},
                                                {"**ACE**", 7, "ACE"},
                                                {"xar!", 0, "XAR"},
                                                {"LZIP", 0, "lzip"},
                                                {"StuffIt", 0, "StuffIt"},
                                                {"\x1f\x9d", 0, "compress"}}};
constexpr std::array<std::string_view, 16> unopenedSuffixes{".rar", ".lzh",  ".lha", ".arj", ".cab", ".ace",
                                                            ".sit", ".sitx", ".dmg", ".iso", ".alz", ".egg",
                                                            ".lz",  ".lzma", ".z01", ".001"};

struct Ending {
  std::string_view suffix;
  const char* why;
};
constexpr std::array<Ending, 16> endings{{{".icloud", placeholder},
                                          {".cloud", placeholder},
                                          {".cloudf", placeholder},
                                          {".gdoc", placeholder},
                                          {".lnk", shortcut},
                                          {".url", shortcut},
                                          {".webloc", shortcut},
                                          {".desktop", shortcut},
                                          {".crdownload", unfinished},
                                          {".opdownload", unfinished},
                                          {".partial", unfinished},
                                          {".part", unfinished},
                                          {".gz", packedAlone},
                                          {".bz2", packedAlone},
                                          {".xz", packedAlone},
                                          {".zst", packedAlone}}};
constexpr std::array<std::string_view, 3> shortcutWords{" - shortcut", " - acceso directo", " alias"};

bool isCompressed(std::string_view bytes) { return compressionOf(bytes) != ARCHIVE_FILTER_NONE; }

std::optional<StandIn> unopened(const std::string& lower, std::string_view head) {
  for (const Kind& kind : unopenedContents) {
    if (head.substr(std::min(kind.offset, head.size())).starts_with(kind.mark))
      return StandIn{"", fmt::format("an archive of the kind {} is not opened: {}", kind.name, handInOther)};
  }
  for (const std::string_view suffix : unopenedSuffixes) {
    if (lower.size() > suffix.size() && lower.ends_with(suffix))
      return StandIn{"", fmt::format("an archive of the kind {} is not opened: {}", suffix, handInOther)};
  }
  return std::nullopt;
}

/// What "spring_1d.cpp - Shortcut.lnk" and ".spring_1d.cpp.icloud" stand for.
std::string nameInside(std::string name, std::size_t suffixBytes) {
  name.resize(name.size() - suffixBytes);
  if (name.starts_with('.')) name.erase(0, 1);
  for (const std::string_view word : shortcutWords) {
    if (lowerCase(name).ends_with(word)) name.resize(name.size() - word.size());
  }
  const bool mayBeAnything = isArchiveName(name) || name.find('.') == std::string::npos;
  return mayBeAnything ? "" : name;
}

}  // namespace

int compressionOf(std::string_view bytes) {
  if (bytes.starts_with("\x1f\x8b")) return ARCHIVE_FILTER_GZIP;
  if (bytes.starts_with("BZh")) return ARCHIVE_FILTER_BZIP2;
  if (bytes.starts_with(std::string_view("\xfd"
                                         "7zXZ\0",
                                         6)))
    return ARCHIVE_FILTER_XZ;
  if (bytes.starts_with("\x28\xb5\x2f\xfd")) return ARCHIVE_FILTER_ZSTD;
  return ARCHIVE_FILTER_NONE;
}

bool beginsAsArchive(std::string_view bytes) {
  constexpr std::size_t tarMark = 257;
  const bool isTar = bytes.size() > tarMark && bytes.substr(tarMark).starts_with("ustar");
  return isTar || isCompressed(bytes) || bytes.starts_with("PK\x03\x04") || bytes.starts_with("PK\x05\x06") ||
         bytes.starts_with("PK\x07\x08") || bytes.starts_with("7z\xbc\xaf\x27\x1c");
}

bool isArchive(const std::string& name, std::string_view head) {
  if (isArchiveName(name)) return true;
  if (!beginsAsArchive(head) || (isCompressed(head) && name.find('.') != std::string::npos)) return false;
  const std::string lower = lowerCase(name);
  return std::none_of(documents.begin(), documents.end(), [&](auto suffix) { return lower.ends_with(suffix); });
}

std::optional<StandIn> standIn(const std::string& name, std::string_view head) {
  const std::string lower = lowerCase(name);
  for (const Ending& ending : endings) {
    // "hand_in.tar.gz" is an archive that is opened, a compressed file alone is not.
    if (lower.size() > ending.suffix.size() && lower.ends_with(ending.suffix) && !isArchiveName(name))
      return StandIn{nameInside(name, ending.suffix.size()), ending.why};
  }
  return unopened(lower, head);
}

}  // namespace muelle::grader
