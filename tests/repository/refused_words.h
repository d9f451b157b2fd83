#pragma once
/// \file
/// What must not stand in what is handed out, since a student's machine lacks it: one list, with the reason for each.

#include <array>

namespace muelle {

/// A word that is refused, where it begins and ends as a word.
struct RefusedWord {
  const char* word;    ///< a regular expression (ECMAScript)
  const char* reason;  ///< why, and what to take instead
};

/// In C++, outside of `#ifdef __linux__`.
inline constexpr std::array refusedInSources = {
    RefusedWord{R"(\bpipe2\s*\()", "macOS has pipe and fcntl(FD_CLOEXEC); base/process/child.h has makePipe"},
    RefusedWord{R"(\baccept4\s*\()", "macOS has accept and fcntl"},
    RefusedWord{R"(\bdup3\s*\()", "macOS has dup2 and fcntl"},
    RefusedWord{R"(\bmemfd_create\s*\()", "macOS has none; a temporary file does as well"},
    RefusedWord{R"(\bprctl\s*\()", "macOS has none"},
    RefusedWord{R"(\bepoll_\w+\s*\()", "macOS has poll"},
    RefusedWord{R"(\b(event|signal|timer|pid)fd(_\w+)?\s*\()", "macOS has none; a pipe does as well"},
    RefusedWord{R"(\binotify_\w+\s*\()", "macOS has none; look again after a while"},
    RefusedWord{R"(\b(unshare|setns|clone3?|sched_[sg]etaffinity|getrandom|copy_file_range|execvpe|sendfile)\s*\()",
                "Linux alone has it, or it means something else on macOS"},
    RefusedWord{R"(\bsyscall\s*\()", "numbers of system calls are Linux's"},
    RefusedWord{R"(\b(mallopt|malloc_trim|mallinfo2?)\s*\()", "glibc alone has it"},
    RefusedWord{R"(\bsecure_getenv\s*\()", "macOS has getenv"},
    RefusedWord{R"(\bget_current_dir_name\s*\()", "macOS has getcwd"},
    RefusedWord{R"(\bposix_fallocate\s*\()", "macOS has ftruncate"},
    RefusedWord{R"(\bclock_nanosleep\s*\()", "macOS has nanosleep; the standard library has sleep_until"},
    RefusedWord{R"(\bpthread_setname_np\s*\(\s*pthread_self)", "macOS's takes the name alone"},
    RefusedWord{R"(\b(strerrorname_np|strchrnul|mempcpy|memrchr|tempnam)\s*\()", "macOS has none"},
    RefusedWord{R"(\b(O_PATH|O_TMPFILE|MAP_POPULATE|MSG_CMSG_CLOEXEC|SOCK_CLOEXEC|SOCK_NONBLOCK|RLIMIT_RTTIME)\b)",
                "Linux alone has it"},
    RefusedWord{R"(\bprogram_invocation_(short_)?name\b)", "macOS has getprogname"},
    RefusedWord{R"("/proc\b)", "macOS has no /proc"},
    RefusedWord{R"("/dev/shm\b)", "macOS has no /dev/shm"},
    RefusedWord{R"(#\s*include\s*<sys/(prctl|epoll|inotify|eventfd|signalfd|timerfd|sendfile|sysinfo|syscall)\.h>)",
                "macOS has no such header"},
    RefusedWord{R"(#\s*include\s*<((linux|asm|bits|ext)/|(malloc|link|error|features|seccomp)\.h>))",
                "macOS has no such header"},
};

/// In the launcher: words of a later bash than 3.2, which macOS has, and commands and options that macOS lacks.
inline constexpr std::array refusedInLauncher = {
    RefusedWord{R"(\b(mapfile|readarray)\b)", "bash 4: while IFS= read -r line; do ...; done < <(...)"},
    RefusedWord{R"(\b(declare|local|typeset)\s+-\w*[Agn])", "bash 4: associative arrays, -g and name references"},
    RefusedWord{R"(\$\{[\w@*#?!]+(\[[^\]]*\])?(\^|,))", "bash 4: change the case with tr"},
    RefusedWord{R"(\$\{\w+(\[[^\]]*\])?@[A-Za-z]\})", "bash 4.4: ${x@Q}; printf %q"},
    RefusedWord{R"(&>>)", "bash 4: >>file 2>&1"},
    RefusedWord{R"(\|&)", "bash 4: 2>&1 |"},
    RefusedWord{R"(;;?&)", "bash 4: a case has ;; alone"},
    RefusedWord{R"(\bcoproc\b)", "bash 4"},
    RefusedWord{R"(\bwait\s+-n\b)", "bash 4.3"},
    RefusedWord{R"(\b(BASHPID|EPOCHSECONDS|EPOCHREALTIME|SRANDOM|XTRACEFD)\b)", "bash 4 and later"},
    RefusedWord{R"(\bshopt\s+-\w\s+(globstar|lastpipe|inherit_errexit|autocd)\b)", "bash 4 and later"},
    RefusedWord{R"(\bexec\s+\{\w+\})", "bash 4.1: a number for the descriptor"},
    RefusedWord{R"(\$\{\w+\[-\d+\]\})", "bash 4.3: count from the beginning"},
    RefusedWord{R"(\[\[\s+-[vR]\s)", "bash 4.2: ${x+set}"},
    RefusedWord{R"(%\(.*\)T)", "bash 4.2: date"},
    RefusedWord{R"(\bread\s+(-\w+\s+)*-\w*[Ni]\b)", "bash 4"},
    RefusedWord{R"(\bread\s+(-\w+\s+)*-t\s*\d*\.\d)", "bash 4: whole seconds"},
    RefusedWord{R"x((^|[^+])"\$\{(?!packages|targets)\w+\[@\]\}")x",  // those two are never empty
                "bash before 4.4 takes an empty array under set -u for an unset one: ${a[@]+\"${a[@]}\"}"},
    RefusedWord{R"((^|[^:\w])flock +[-0-9])", "macOS has no such command: perl can lock a descriptor"},
    RefusedWord{R"(\bsetsid\b)", "macOS has none"},
    RefusedWord{R"(\btimeout\b)", "macOS has none"},
    RefusedWord{R"(\breadlink\s+-\w*[fem])", "macOS before 12.3 has none: cd and pwd -P"},
    RefusedWord{R"(\brealpath\b)", "macOS before 13 has none: cd and pwd -P"},
    RefusedWord{R"(\bstat\s+(-c|--format|--printf))", "macOS has stat -f"},
    RefusedWord{R"(\bsed\s+(-\w+\s+)*(-\w*i\s|--in-place))", "macOS wants a suffix: write another file and rename it"},
    RefusedWord{R"(\b(grep|egrep)\s+-\w*P)", "macOS has no Perl expressions"},
    RefusedWord{R"(\bdate\s+(-d|--date|\+%N|-\w*I))", "macOS has date -v"},
    RefusedWord{R"(\b(nproc|tac|shuf|numfmt|getent|free|ldconfig|pidof|setpriv|prlimit|ionice|taskset)\b)",
                "macOS has none"},
    RefusedWord{R"(\bxargs\s+(-\w+\s+)*(-\w*r\b|--no-run))", "macOS has none"},
    RefusedWord{R"(\bcp\s+(-\w+\s+)*(--\w+|-\w*[au]\b))", "macOS lacks it"},
    RefusedWord{R"(\b(ls|mv|ln|rm|mkdir|tail|head|sort|cut|tr|wc|touch|ps|sleep|find|mktemp)\s+(-\w+\s+)*--\w)",
                "macOS has no long options"},
    RefusedWord{R"(\bmktemp\s+(-\w+\s+)*-\w*p)", "macOS has none: a template"},
    RefusedWord{R"(\bhead\s+-\w*n?\s*-\d+c?\s*-)", "macOS counts from the beginning alone"},
    RefusedWord{R"(\bfind\s.*-printf\b)", "macOS has none"},
    RefusedWord{R"(\becho\s+-[ne])", "differs between shells: printf"},
    RefusedWord{R"(\\e\[)", "not every printf knows it: \\033["},
};

}  // namespace muelle
