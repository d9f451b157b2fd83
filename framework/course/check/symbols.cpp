#include "course/check/symbols.h"

#include "base/text/printable.h"

#include <cxxabi.h>
#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <memory>
#include <span>
#include <system_error>

namespace muelle {

namespace {

constexpr std::string_view keyboard = "reads the keyboard ({}): nobody types while it is tested";
constexpr std::string_view files = "works with files ({}): what it needs comes as arguments";
constexpr std::string_view programs = "runs programs ({}): it can only compute";
constexpr std::string_view threads = "starts threads ({}): one is enough for every exercise";
constexpr std::string_view network = "talks to a network ({}): it can only compute";
constexpr std::string_view sleeps = "waits ({}): a function returns as soon as it has computed";
constexpr std::string_view signals = "sends or handles signals ({}): throw an exception, or return";
constexpr std::string_view memory = "asks for memory beside new and std::vector ({})";
constexpr std::string_view terminal = "asks for a terminal ({}): it runs without one";
constexpr std::string_view descriptors = "prints past the streams ({}): write to std::cout or std::cerr";
constexpr std::string_view processors = "asks for the machine's processors ({}): one is enough for every exercise";
constexpr std::string_view timeZones = "asks for the time of a place ({}): what it needs comes as arguments";
constexpr std::string_view locales = "changes language and country ({}): numbers are read and written as in C++";
constexpr std::string_view randomness =
    "takes random numbers from the machine ({}): equal arguments give equal results";
constexpr std::string_view arithmetic = "changes how numbers are computed with ({}): leave that as it is";
constexpr std::string_view system = "asks the operating system ({}): what it needs comes as arguments";

/// A symbol that no exercise needs.
struct Unneeded {
  std::string_view symbol;  ///< whole name of a C function, or the beginning of a mangled name
  std::string_view shown;   ///< as the student writes it; "": the symbol
  std::string_view sentence;
};

/// Parts of the C++ library: any symbol that begins so, of GNU's library and of LLVM's.
constexpr auto parts = std::to_array<Unneeded>({
    {"_ZSt3cin", "std::cin", keyboard},
    {"_ZSt4wcin", "std::wcin", keyboard},
    {"_ZNSt3__13cinE", "std::cin", keyboard},
    {"_ZNSt3__14wcinE", "std::wcin", keyboard},
    {"_ZNSt14basic_ifstream", "std::ifstream", files},
    {"_ZNSt14basic_ofstream", "std::ofstream", files},
    {"_ZNSt13basic_fstream", "std::fstream", files},
    {"_ZNSt13basic_filebuf", "std::filebuf", files},
    {"_ZNSt3__114basic_ifstream", "std::ifstream", files},
    {"_ZNSt3__114basic_ofstream", "std::ofstream", files},
    {"_ZNSt3__113basic_fstream", "std::fstream", files},
    {"_ZNSt3__113basic_filebuf", "std::filebuf", files},
    {"_ZNSt10filesystem", "std::filesystem", files},
    {"_ZNKSt10filesystem", "std::filesystem", files},
    {"_ZNSt3__14__fs10filesystem", "std::filesystem", files},
    {"_ZNKSt3__14__fs10filesystem", "std::filesystem", files},
    {"_ZNSt6thread15_M_start_thread", "std::thread", threads},
    {"_ZNSt3__16thread20hardware_concurrencyEv", "std::thread::hardware_concurrency", processors},
    {"_ZNSt3__16thread", "std::thread", threads},
    {"_ZNSt6thread20hardware_concurrencyEv", "std::thread::hardware_concurrency", processors},
    {"_ZNSt6localeC1EPKc", "std::locale", locales},
    {"_ZNSt6localeC2EPKc", "std::locale", locales},
    {"_ZNSt6localeC1ERKS_PKc", "std::locale", locales},
    {"_ZNSt6localeC2ERKS_PKc", "std::locale", locales},
    {"_ZNSt3__16localeC1EPKc", "std::locale", locales},
    {"_ZNSt3__16localeC1ERKNS_12basic_string", "std::locale", locales},
    {"_ZNSt13random_device", "std::random_device", randomness},
    {"_ZNSt3__113random_device", "std::random_device", randomness},
    {"_ZNSt6chrono8get_tzdb", "std::chrono::get_tzdb", timeZones},
    {"_ZNSt6chrono11locate_zone", "std::chrono::locate_zone", timeZones},
    {"_ZNSt6chrono12current_zone", "std::chrono::current_zone", timeZones},
    {"_ZNSt11this_thread", "std::this_thread", sleeps},
    {"_ZNSt3__111this_thread", "std::this_thread", sleeps},
});

/// Functions and variables of the C library. Absent on purpose: what printing, assertions, containers and exit() need;
/// exit() and its kin are a crash when they are called.
constexpr auto functions = std::to_array<Unneeded>({
    {"stdin", "", keyboard},
    {"__stdinp", "stdin", keyboard},
    {"scanf", "", keyboard},
    {"vscanf", "", keyboard},
    {"__isoc99_scanf", "scanf", keyboard},
    {"__isoc99_vscanf", "vscanf", keyboard},
    {"__isoc23_scanf", "scanf", keyboard},
    {"__isoc23_vscanf", "vscanf", keyboard},
    {"getchar", "", keyboard},
    {"getchar_unlocked", "", keyboard},
    {"gets", "", keyboard},
    {"getwchar", "", keyboard},
    {"fopen", "", files},
    {"freopen", "", files},
    {"fdopen", "", files},
    {"tmpfile", "", files},
    {"remove", "", files},
    {"rename", "", files},
    {"open", "", files},
    {"__open_2", "open", files},
    {"__open64_2", "open", files},
    {"openat", "", files},
    {"creat", "", files},
    {"read", "", files},
    {"readv", "", files},
    {"pread", "", files},
    {"write", "", files},
    {"writev", "", files},
    {"pwrite", "", files},
    {"close", "", files},
    {"close_range", "", files},
    {"closefrom", "", files},
    {"dup", "", files},
    {"dup2", "", files},
    {"dup3", "", files},
    {"pipe", "", files},
    {"pipe2", "", files},
    {"fcntl", "", files},
    {"ioctl", "", files},
    {"flock", "", files},
    {"lockf", "", files},
    {"lseek", "", files},
    {"sendfile", "", files},
    {"splice", "", files},
    {"unlink", "", files},
    {"unlinkat", "", files},
    {"link", "", files},
    {"linkat", "", files},
    {"symlink", "", files},
    {"symlinkat", "", files},
    {"renameat", "", files},
    {"mkdir", "", files},
    {"mkdirat", "", files},
    {"mkfifo", "", files},
    {"mknod", "", files},
    {"rmdir", "", files},
    {"opendir", "", files},
    {"fdopendir", "", files},
    {"scandir", "", files},
    {"nftw", "", files},
    {"ftw", "", files},
    {"glob", "", files},
    {"chdir", "", files},
    {"fchdir", "", files},
    {"chroot", "", files},
    {"chmod", "", files},
    {"fchmod", "", files},
    {"fchmodat", "", files},
    {"chown", "", files},
    {"fchown", "", files},
    {"utime", "", files},
    {"utimes", "", files},
    {"utimensat", "", files},
    {"futimens", "", files},
    {"truncate", "", files},
    {"ftruncate", "", files},
    {"stat", "", files},
    {"lstat", "", files},
    {"fstat", "", files},
    {"fstatat", "", files},
    {"access", "", files},
    {"readlink", "", files},
    {"realpath", "", files},
    {"mkstemp", "", files},
    {"mkdtemp", "", files},
    {"mount", "", files},
    {"umount", "", files},
    {"system", "", programs},
    {"popen", "", programs},
    {"fork", "", programs},
    {"vfork", "", programs},
    {"_Fork", "", programs},
    {"clone", "", programs},
    {"daemon", "", programs},
    {"setsid", "", programs},
    {"execl", "", programs},
    {"execle", "", programs},
    {"execlp", "", programs},
    {"execv", "", programs},
    {"execve", "", programs},
    {"execvp", "", programs},
    {"execvpe", "", programs},
    {"fexecve", "", programs},
    {"posix_spawn", "", programs},
    {"posix_spawnp", "", programs},
    {"wait", "", programs},
    {"waitpid", "", programs},
    {"pthread_exit", "", threads},
    {"pthread_create", "", threads},
    {"thrd_create", "", threads},
    {"socket", "", network},
    {"socketpair", "", network},
    {"connect", "", network},
    {"bind", "", network},
    {"listen", "", network},
    {"accept", "", network},
    {"accept4", "", network},
    {"send", "", network},
    {"sendto", "", network},
    {"sendmsg", "", network},
    {"recv", "", network},
    {"recvfrom", "", network},
    {"recvmsg", "", network},
    {"getaddrinfo", "", network},
    {"gethostbyname", "", network},
    {"sleep", "", sleeps},
    {"usleep", "", sleeps},
    {"nanosleep", "", sleeps},
    {"clock_nanosleep", "", sleeps},
    {"thrd_sleep", "", sleeps},
    {"pause", "", sleeps},
    {"select", "", sleeps},
    {"pselect", "", sleeps},
    {"poll", "", sleeps},
    {"ppoll", "", sleeps},
    {"epoll_wait", "", sleeps},
    {"kill", "", signals},
    {"killpg", "", signals},
    {"tgkill", "", signals},
    {"raise", "", signals},
    {"pthread_kill", "", signals},
    {"signal", "", signals},
    {"__sysv_signal", "signal", signals},
    {"sigset", "", signals},
    {"sigaction", "", signals},
    {"sigprocmask", "", signals},
    {"pthread_sigmask", "", signals},
    {"sigaltstack", "", signals},
    {"sigqueue", "", signals},
    {"sigsuspend", "", signals},
    {"sigwait", "", signals},
    {"alarm", "", signals},
    {"setitimer", "", signals},
    {"timer_create", "", signals},
    {"mmap", "", memory},
    {"munmap", "", memory},
    {"mremap", "", memory},
    {"mprotect", "", memory},
    {"mlock", "", memory},
    {"mlockall", "", memory},
    {"brk", "", memory},
    {"sbrk", "", memory},
    {"memfd_create", "", memory},
    {"shm_open", "", memory},
    {"shm_unlink", "", memory},
    {"shmget", "", memory},
    {"shmat", "", memory},
    {"semget", "", system},
    {"sem_open", "", system},
    {"msgget", "", system},
    {"msgsnd", "", system},
    {"msgrcv", "", system},
    {"mq_open", "", system},
    {"syscall", "", system},
    {"ptrace", "", system},
    {"prctl", "", system},
    {"process_vm_readv", "", system},
    {"process_vm_writev", "", system},
    {"personality", "", system},
    {"setrlimit", "", system},
    {"prlimit", "", system},
    {"unshare", "", system},
    {"setns", "", system},
    {"setuid", "", system},
    {"setgid", "", system},
    {"getuid", "", system},
    {"getpid", "", system},
    {"getppid", "", system},
    {"uname", "", system},
    {"gethostname", "", system},
    {"getenv", "", system},
    {"secure_getenv", "", system},
    {"setenv", "", system},
    {"putenv", "", system},
    {"environ", "", system},
    {"__environ", "environ", system},
    {"_environ", "environ", system},
    {"dlopen", "", system},
    {"dlmopen", "", system},
    {"dlsym", "", system},
    {"dlvsym", "", system},
    {"dl_iterate_phdr", "", system},
    {"inotify_init", "", system},
    {"add_key", "", system},
    {"keyctl", "", system},
    {"fclose", "", files},
    {"fseek", "", files},
    {"fseeko", "", files},
    {"ftell", "", files},
    {"ftello", "", files},
    {"rewind", "", files},
    {"fgetpos", "", files},
    {"fsetpos", "", files},
    {"faccessat", "", files},
    {"euidaccess", "", files},
    {"eaccess", "", files},
    {"statx", "", files},
    {"statfs", "", files},
    {"fstatfs", "", files},
    {"statvfs", "", files},
    {"fstatvfs", "", files},
    {"pathconf", "", files},
    {"fpathconf", "", files},
    {"umask", "", files},
    {"sync", "", files},
    {"syncfs", "", files},
    {"fsync", "", files},
    {"fdatasync", "", files},
    {"getcwd", "", files},
    {"get_current_dir_name", "", files},
    {"getwd", "", files},
    {"canonicalize_file_name", "", files},
    {"iconv_open", "", files},
    {"catopen", "", files},
    {"wordexp", "", programs},
    {"perror", "", descriptors},
    {"dprintf", "", descriptors},
    {"vdprintf", "", descriptors},
    {"backtrace_symbols_fd", "", descriptors},
    {"syslog", "", descriptors},
    {"vsyslog", "", descriptors},
    {"isatty", "", terminal},
    {"ttyname", "", terminal},
    {"ttyname_r", "", terminal},
    {"tcgetattr", "", terminal},
    {"tcsetattr", "", terminal},
    {"getpass", "", terminal},
    {"sysconf", "", processors},
    {"get_nprocs", "", processors},
    {"get_nprocs_conf", "", processors},
    {"get_phys_pages", "", processors},
    {"get_avphys_pages", "", processors},
    {"getloadavg", "", processors},
    {"sched_getaffinity", "", processors},
    {"sched_setaffinity", "", processors},
    {"pthread_getaffinity_np", "", processors},
    {"pthread_setaffinity_np", "", processors},
    {"ctime", "", timeZones},
    {"ctime_r", "", timeZones},
    {"localtime", "", timeZones},
    {"localtime_r", "", timeZones},
    {"gmtime", "", timeZones},
    {"gmtime_r", "", timeZones},
    {"mktime", "", timeZones},
    {"timelocal", "", timeZones},
    {"timegm", "", timeZones},
    {"tzset", "", timeZones},
    {"getdate", "", timeZones},
    {"getdate_r", "", timeZones},
    {"strftime", "", timeZones},
    {"strftime_l", "", timeZones},
    {"wcsftime", "", timeZones},
    {"wcsftime_l", "", timeZones},
    {"setlocale", "", locales},
    {"newlocale", "", locales},
    {"pthread_getattr_np", "", threads},
    {"pthread_setname_np", "", threads},
    {"pthread_getname_np", "", threads},
    {"pthread_setschedparam", "", threads},
    {"getservbyname", "", network},
    {"getservbyport", "", network},
    {"getprotobyname", "", network},
    {"gethostbyaddr", "", network},
    {"getnameinfo", "", network},
    {"getifaddrs", "", network},
    {"if_nameindex", "", network},
    {"sigpending", "", signals},
    {"siginterrupt", "", signals},
    {"sigwaitinfo", "", signals},
    {"sigtimedwait", "", signals},
    {"signalfd", "", signals},
    {"bsd_signal", "", signals},
    {"getitimer", "", signals},
    {"ualarm", "", signals},
    {"munlock", "", memory},
    {"munlockall", "", memory},
    {"mincore", "", memory},
    {"msync", "", memory},
    {"getrusage", "", system},
    {"times", "", system},
    {"getrlimit", "", system},
    {"geteuid", "", system},
    {"getgid", "", system},
    {"getegid", "", system},
    {"getsid", "", system},
    {"getpgid", "", system},
    {"getlogin", "", system},
    {"getlogin_r", "", system},
    {"cuserid", "", system},
    {"getpwuid", "", system},
    {"getpwuid_r", "", system},
    {"getpwnam", "", system},
    {"getpwnam_r", "", system},
    {"getgrgid", "", system},
    {"getgrnam", "", system},
    {"getdomainname", "", system},
    {"gethostid", "", system},
    {"sysinfo", "", system},
    {"getpriority", "", system},
    {"setpriority", "", system},
    {"nice", "", system},
    {"sched_getscheduler", "", system},
    {"sched_setscheduler", "", system},
    {"sched_get_priority_max", "", system},
    {"sched_get_priority_min", "", system},
    {"feenableexcept", "", arithmetic},
    {"fesetenv", "", arithmetic},
    {"feupdateenv", "", arithmetic},
});

/// A Mac's assembler puts an underscore before every name; a version may stand behind it ("open@GLIBC_2.2.5").
std::string_view plain(std::string_view symbol) {
  symbol = symbol.substr(0, symbol.find('@'));
#ifdef __APPLE__
  if (symbol.starts_with('_')) symbol.remove_prefix(1);
#endif
  return symbol;
}

/// "getcwd" of "__getcwd_chk", which a compiler makes of it that guards lengths; "fopen" of "fopen64".
std::string_view plainName(std::string_view symbol) {
  if (symbol.starts_with("__") && symbol.ends_with("_chk")) return symbol.substr(2, symbol.size() - 6);
  if (symbol.ends_with("64")) symbol.remove_suffix(2);
  return symbol;
}

/// The entry of the tables that says what the symbol is; null when an exercise may need it.
const Unneeded* unneeded(std::string_view symbol) {
  const auto part = std::ranges::find_if(parts, [&](const Unneeded& u) { return symbol.starts_with(u.symbol); });
  if (part != parts.end()) return &*part;
  auto function = std::ranges::find(functions, symbol, &Unneeded::symbol);
  if (function == functions.end()) function = std::ranges::find(functions, plainName(symbol), &Unneeded::symbol);
  return function != functions.end() ? &*function : nullptr;
}

/// Functions that hand out the memory of the whole program, in a file that defines them: the checking program's, too.
constexpr auto allocators =
    std::to_array<std::string_view>({"malloc", "free", "calloc", "realloc", "reallocarray", "aligned_alloc", "memalign",
                                     "posix_memalign", "valloc", "pvalloc", "malloc_usable_size"});

/// "operator new" of one of its forms that a program may replace, "" of any other symbol: a class's own, or one with
/// arguments of the student's, replaces nothing.
std::string_view replacedOperator(std::string_view symbol) {
  const std::string_view name = symbol.substr(0, std::min<std::size_t>(symbol.size(), 4));
  const bool isNew = name == "_Znw" || name == "_Zna";
  const bool isDelete = name == "_Zdl" || name == "_Zda";
  if (!isNew && !isDelete) return "";
  std::string_view arguments = symbol.substr(name.size());
  const auto drop = [&arguments](std::string_view argument) {
    const bool isThere = arguments.starts_with(argument);
    if (isThere) arguments.remove_prefix(argument.size());
    return isThere;
  };
  if (isDelete && !drop("Pv")) return "";
  const bool hasSize = drop("m") || drop("j");
  if (isNew && !hasSize) return "";
  drop("St11align_val_t");
  drop("RKSt9nothrow_t");
  if (!arguments.empty()) return "";
  return isNew ? "operator new" : "operator delete";
}

/// What of the program's memory the file replaces, as the student writes it; "" when nothing.
std::string_view replacedAllocator(const std::vector<std::string>& defined) {
  // nm sorts by name: delete would come first, and nobody replaces it alone.
  std::string_view released;
  for (const std::string& symbol : defined) {
    const std::string_view name = replacedOperator(symbol);
    if (name == "operator new") return name;
    if (!name.empty()) released = name;
    if (const auto found = std::ranges::find(allocators, symbol); found != allocators.end()) return *found;
  }
  return released;
}

/// Names that others look up in the program that a student's file becomes part of; those of C++ carry their types and
/// begin otherwise.
constexpr auto ofTheCourse = std::to_array<std::string_view>({"muelle"});
constexpr auto ofSanitizers =
    std::to_array<std::string_view>({"__asan_", "__ubsan_", "__lsan_", "__tsan_", "__msan_", "__sanitizer_"});

/// The first symbol that begins with one of the names; "" when none does.
std::string firstOf(const std::vector<std::string>& symbols, std::span<const std::string_view> beginnings) {
  const auto found = std::ranges::find_if(symbols, [beginnings](const std::string& symbol) {
    return std::ranges::any_of(beginnings, [&](std::string_view beginning) { return symbol.starts_with(beginning); });
  });
  return found == symbols.end() ? "" : *found;
}

/// Of initialised, zeroed, constant, common and shared data.
bool isData(char kind) { return std::string_view("BbDdRrCGgSsuVv").find(kind) != std::string_view::npos; }

/// The last of "kind value size", which is hexadecimal; 0 where there is none.
std::size_t sizeIn(std::string_view fields) {
  const std::size_t blank = fields.rfind(' ');
  std::size_t bytes = 0;
  if (blank == std::string_view::npos) return 0;
  const auto [end, error] = std::from_chars(fields.data() + blank + 1, fields.data() + fields.size(), bytes, 16);
  return error == std::errc() ? bytes : 0;
}

/// "lumpedMass(double, int)::table" of its symbol.
std::string readableName(const std::string& symbol) {
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> name(abi::__cxa_demangle(symbol.c_str(), nullptr, nullptr, &status),
                                                         &std::free);
  return status == 0 && name ? name.get() : symbol;
}

/// Of the 1 GiB of address space that a program has in check and in grade, what its static data may take.
constexpr std::size_t mostStaticData = 512UL << 20U;

/// What a table that does not fit is called, and how large it is; "" when all of them fit.
std::string oversize(const std::vector<StaticData>& data) {
  double total = 0;  // the sizes are the submission's: no sum of integers
  for (const StaticData& item : data) total += static_cast<double>(item.bytes);
  if (total <= static_cast<double>(mostStaticData)) return "";
  const StaticData& largest = *std::ranges::max_element(data, {}, &StaticData::bytes);
  return fmt::format("{} takes {} MiB of memory before anything runs; all static variables together may take {}",
                     printableLine(readableName(largest.symbol)), largest.bytes >> 20U, mostStaticData >> 20U);
}

void addOnce(std::vector<std::string>& names, std::string_view name) {
  if (std::ranges::find(names, name) == names.end()) names.emplace_back(name);
}

}  // namespace

Symbols readSymbols(std::string_view nmText) {
  Symbols symbols;
  std::vector<std::string> used;
  while (!nmText.empty()) {
    const std::size_t end = std::min(nmText.find('\n'), nmText.size());
    const std::string_view line = nmText.substr(0, end);
    nmText.remove_prefix(std::min(end + 1, nmText.size()));
    // "name kind value size"; a line without kind is the name of a file
    const std::size_t blank = line.find(' ');
    if (blank == std::string_view::npos || blank + 1 >= line.size()) continue;
    const std::string_view name = plain(line.substr(0, blank));
    const char kind = line[blank + 1];
    const bool isUndefined = kind == 'U' || kind == 'w' || kind == 'v';
    const bool isGlobal = kind >= 'A' && kind <= 'Z';
    if (isUndefined) addOnce(used, name);
    if (!isUndefined && isGlobal) addOnce(symbols.defined, name);
    if (isData(kind)) symbols.data.push_back({std::string(name), sizeIn(line.substr(blank + 1))});
  }
  for (const std::string& name : used) {
    if (std::ranges::find(symbols.defined, name) == symbols.defined.end()) symbols.undefined.push_back(name);
  }
  return symbols;
}

std::string symbolRules() {
  std::string rules;
  const auto addAll = [&rules](const auto& table) {
    for (const Unneeded& u : table) rules += fmt::format("{} {} {}\n", u.symbol, u.shown, u.sentence);
  };
  addAll(parts);
  addAll(functions);
  rules += fmt::format("{}\n", mostStaticData);
  for (const std::string_view name : allocators) rules += fmt::format("{}\n", name);
  for (const std::string_view name : ofTheCourse) rules += fmt::format("{}\n", name);
  for (const std::string_view name : ofSanitizers) rules += fmt::format("{}\n", name);
  return rules;
}

SymbolVerdict judgeSymbols(const Symbols& symbols) {
  if (std::ranges::find(symbols.defined, "main") != symbols.defined.end()) {
    return {Outcome::Link, "your file defines main: leave it out"};
  }
  if (const std::string name = firstOf(symbols.defined, ofTheCourse); !name.empty()) {
    return {Outcome::Link, fmt::format("{} is defined in your file: the course has a function of that name", name)};
  }
  if (const std::string name = firstOf(symbols.defined, ofSanitizers); !name.empty()) {
    return {Outcome::Forbidden, fmt::format("it defines {}, which is for the sanitizers to define", name)};
  }
  if (const std::string_view name = replacedAllocator(symbols.defined); !name.empty()) {
    return {Outcome::Forbidden, fmt::format("it replaces {} for the whole program: leave it out", name)};
  }
  if (const std::string what = oversize(symbols.data); !what.empty()) {
    return {Outcome::Crash, "it does not fit into memory: " + what};
  }
  for (const std::string& symbol : symbols.undefined) {
    if (const Unneeded* found = unneeded(symbol)) {
      const std::string_view name = found->shown.empty() ? found->symbol : found->shown;
      return {Outcome::Forbidden, "it " + fmt::format(fmt::runtime(found->sentence), name)};
    }
  }
  return {};
}

}  // namespace muelle
