#include "grader/sandbox/handover.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace muelle::grader {

Descriptor openForHandover(const VisibleFile& file) {
  if (!file.source.empty()) {
    Descriptor opened(open(file.source.c_str(), O_RDONLY | O_CLOEXEC));
    if (!opened) throw std::runtime_error("cannot read " + file.source.string() + ": " + std::strerror(errno));
    return opened;
  }
  Descriptor memory(memfd_create("handover", MFD_CLOEXEC));
  if (!memory) throw std::runtime_error(std::string("cannot make a file in memory: ") + std::strerror(errno));
  std::size_t written = 0;
  while (written < file.content.size()) {
    const ssize_t count = write(memory.get(), file.content.data() + written, file.content.size() - written);
    if (count <= 0) throw std::runtime_error("cannot fill a file in memory");
    written += static_cast<std::size_t>(count);
  }
  lseek(memory.get(), 0, SEEK_SET);
  return memory;
}

std::vector<std::string> unprivilegedPrefix() {
  if (geteuid() != 0) return {};
  const std::string id = std::to_string(unassignedUserId());
  return {"/usr/bin/setpriv",    "--reuid",        id,  "--regid", id, "--clear-groups", "--inh-caps=-all",
          "--bounding-set=-all", "--no-new-privs", "--"};
}

std::string readMessage(int descriptor, std::size_t bytes) {
  std::string text(bytes, '\0');
  std::size_t count = 0;
  while (count < bytes) {
    const ssize_t got = read(descriptor, text.data() + count, bytes - count);
    if (got <= 0) break;
    count += static_cast<std::size_t>(got);
  }
  text.resize(count);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  for (char& c : text) {
    if (c == '\n') c = ' ';
  }
  return text;
}

void append(std::vector<std::string>& command, std::initializer_list<std::string> words) {
  command.insert(command.end(), words);
}

}  // namespace muelle::grader
