# SPDX-License-Identifier: LGPL-2.1-or-later
"""System calls of Linux: their numbers, and which of them a process that reads foreign files is not to make."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Machine:
    """The system calls of one kind of processor.

    Attributes
    ----------
    architecture : int
        As the kernel's audit names it.
    seccomp : int
        Number of the call that installs a filter.
    numbers : dict
        Numbers of calls, by name; not every machine has all.
    """

    architecture: int
    seccomp: int
    numbers: dict


FIRST_UNKNOWN = 467
"""The least number of calls that are newer than these tables, on every machine."""

OTHER_NUMBERS = 0x40000000
"""From this number on x86-64 has a second set of its system calls (x32)."""

ATTRIBUTES = frozenset("""
    chmod fchmod fchmodat fchmodat2 chown fchown lchown fchownat utime utimes futimesat utimensat
    setxattr lsetxattr fsetxattr setxattrat removexattr lremovexattr fremovexattr removexattrat truncate flock
""".split())
"""What Landlock does not cover of files: permissions, owners, times, attributes, and locks that others wait for."""

CHANNELS = frozenset("""
    socket socketpair io_uring_setup io_uring_enter io_uring_register
    shmget shmat shmctl shmdt semget semop semctl semtimedop msgget msgsnd msgrcv msgctl
    mq_open mq_unlink mq_timedsend mq_timedreceive mq_notify mq_getsetattr add_key request_key keyctl
""".split())
"""The network, and what programs of the same user share: sockets, System V and POSIX queues and memory, keyrings."""

MEMORY_FILES = frozenset(("memfd_create", "memfd_secret"))
"""Files in memory, which no limit of the address space counts."""

OTHER_PROCESSES = frozenset("""
    tkill rt_sigqueueinfo rt_tgsigqueueinfo ptrace process_vm_readv process_vm_writev process_madvise process_mrelease
    kcmp pidfd_open pidfd_getfd pidfd_send_signal setpriority ioprio_set migrate_pages move_pages
""".split())

GROUPS = frozenset(("setpgid", "setsid"))
"""Ways out of the process group, which is ended as a whole."""

ADMINISTRATION = frozenset("""
    mount umount2 pivot_root chroot open_tree move_mount fsopen fsconfig fsmount fspick mount_setattr unshare setns
    swapon swapoff reboot kexec_load kexec_file_load init_module finit_module delete_module sethostname setdomainname
    settimeofday clock_settime clock_adjtime adjtimex acct quotactl quotactl_fd syslog vhangup iopl ioperm
    bpf perf_event_open userfaultfd fanotify_init fanotify_mark open_by_handle_at lookup_dcookie
""".split())
"""What is for root, or has had most vulnerabilities of the kernel, and is of no use to a reader."""

REFUSED = ATTRIBUTES | CHANNELS | MEMORY_FILES | OTHER_PROCESSES | GROUPS | ADMINISTRATION

SIGNALS = frozenset(("kill", "tgkill"))
"""Calls whose first argument has to be the process itself."""

OWN_SETTINGS = frozenset(("prlimit64", "sched_setaffinity", "sched_setscheduler", "sched_setparam", "sched_setattr"))
"""Calls whose first argument has to be the process itself, by its number or as 0."""

REFUSED_ARGUMENTS = {
    # TIOCSTI, TIOCLINUX: type into the terminal, as the user would
    "ioctl": (0x5412, 0x541C),
    # F_SETOWN, F_SETSIG, F_SETOWN_EX: signals to others; F_SETLEASE, F_NOTIFY: others wait for this process
    "fcntl": (8, 10, 15, 1024, 1026),
}
"""Second arguments that are refused, by call."""

NAMESPACES = 0x7E020000
"""Bits of the first argument of ``clone`` that make namespaces of the kernel, where a user may be root."""

THREAD = 0x00010000
"""Bit of the first argument of ``clone`` that makes a thread instead of a process."""

PROGRAMS = frozenset(("fork", "vfork", "execve", "execveat"))
"""Calls that make processes or run programs, besides ``clone``."""

UNREADABLE = frozenset(("clone3",))
"""Calls whose arguments no filter can read. The C library makes an older call where they seem not to exist."""

MACHINES = {
    "x86_64": Machine(0xC000003E, 317, {
    "ioctl": 16, "shmget": 29, "shmat": 30, "shmctl": 31, "socket": 41, "socketpair": 53, "clone": 56, "fork": 57,
    "vfork": 58, "execve": 59, "kill": 62, "semget": 64, "semop": 65, "semctl": 66, "shmdt": 67, "msgget": 68, "msgsnd":
    69, "msgrcv": 70, "msgctl": 71, "fcntl": 72, "flock": 73, "truncate": 76, "chmod": 90, "fchmod": 91, "chown": 92,
    "fchown": 93, "lchown": 94, "ptrace": 101, "syslog": 103, "setpgid": 109, "setsid": 112, "rt_sigqueueinfo": 129,
    "utime": 132, "setpriority": 141, "sched_setparam": 142, "sched_setscheduler": 144, "vhangup": 153, "pivot_root": 155,
    "adjtimex": 159, "chroot": 161, "acct": 163, "settimeofday": 164, "mount": 165, "umount2": 166, "swapon": 167,
    "swapoff": 168, "reboot": 169, "sethostname": 170, "setdomainname": 171, "iopl": 172, "ioperm": 173, "init_module":
    175, "delete_module": 176, "quotactl": 179, "setxattr": 188, "lsetxattr": 189, "fsetxattr": 190, "removexattr": 197,
    "lremovexattr": 198, "fremovexattr": 199, "tkill": 200, "sched_setaffinity": 203, "lookup_dcookie": 212, "semtimedop":
    220, "clock_settime": 227, "tgkill": 234, "utimes": 235, "mq_open": 240, "mq_unlink": 241, "mq_timedsend": 242,
    "mq_timedreceive": 243, "mq_notify": 244, "mq_getsetattr": 245, "kexec_load": 246, "add_key": 248, "request_key": 249,
    "keyctl": 250, "ioprio_set": 251, "migrate_pages": 256, "fchownat": 260, "futimesat": 261, "fchmodat": 268, "unshare":
    272, "move_pages": 279, "utimensat": 280, "rt_tgsigqueueinfo": 297, "perf_event_open": 298, "fanotify_init": 300,
    "fanotify_mark": 301, "prlimit64": 302, "open_by_handle_at": 304, "clock_adjtime": 305, "setns": 308,
    "process_vm_readv": 310, "process_vm_writev": 311, "kcmp": 312, "finit_module": 313, "sched_setattr": 314,
    "memfd_create": 319, "kexec_file_load": 320, "bpf": 321, "execveat": 322, "userfaultfd": 323, "pidfd_send_signal":
    424, "io_uring_setup": 425, "io_uring_enter": 426, "io_uring_register": 427, "open_tree": 428, "move_mount": 429,
    "fsopen": 430, "fsconfig": 431, "fsmount": 432, "fspick": 433, "pidfd_open": 434, "clone3": 435, "pidfd_getfd": 438,
    "process_madvise": 440, "mount_setattr": 442, "quotactl_fd": 443, "memfd_secret": 447, "process_mrelease": 448,
    "fchmodat2": 452, "setxattrat": 463, "removexattrat": 466,
    }),
    "aarch64": Machine(0xC00000B7, 277, {
    "setxattr": 5, "lsetxattr": 6, "fsetxattr": 7, "removexattr": 14, "lremovexattr": 15, "fremovexattr": 16,
    "lookup_dcookie": 18, "fcntl": 25, "ioctl": 29, "ioprio_set": 30, "flock": 32, "umount2": 39, "mount": 40,
    "pivot_root": 41, "truncate": 45, "chroot": 51, "fchmod": 52, "fchmodat": 53, "fchownat": 54, "fchown": 55, "vhangup":
    58, "quotactl": 60, "utimensat": 88, "acct": 89, "unshare": 97, "kexec_load": 104, "init_module": 105,
    "delete_module": 106, "clock_settime": 112, "syslog": 116, "ptrace": 117, "sched_setparam": 118, "sched_setscheduler":
    119, "sched_setaffinity": 122, "kill": 129, "tkill": 130, "tgkill": 131, "rt_sigqueueinfo": 138, "setpriority": 140,
    "reboot": 142, "setpgid": 154, "setsid": 157, "sethostname": 161, "setdomainname": 162, "settimeofday": 170,
    "adjtimex": 171, "mq_open": 180, "mq_unlink": 181, "mq_timedsend": 182, "mq_timedreceive": 183, "mq_notify": 184,
    "mq_getsetattr": 185, "msgget": 186, "msgctl": 187, "msgrcv": 188, "msgsnd": 189, "semget": 190, "semctl": 191,
    "semtimedop": 192, "semop": 193, "shmget": 194, "shmctl": 195, "shmat": 196, "shmdt": 197, "socket": 198,
    "socketpair": 199, "add_key": 217, "request_key": 218, "keyctl": 219, "clone": 220, "execve": 221, "swapon": 224,
    "swapoff": 225, "migrate_pages": 238, "move_pages": 239, "rt_tgsigqueueinfo": 240, "perf_event_open": 241,
    "prlimit64": 261, "fanotify_init": 262, "fanotify_mark": 263, "open_by_handle_at": 265, "clock_adjtime": 266, "setns":
    268, "process_vm_readv": 270, "process_vm_writev": 271, "kcmp": 272, "finit_module": 273, "sched_setattr": 274,
    "memfd_create": 279, "bpf": 280, "execveat": 281, "userfaultfd": 282, "kexec_file_load": 294, "pidfd_send_signal":
    424, "io_uring_setup": 425, "io_uring_enter": 426, "io_uring_register": 427, "open_tree": 428, "move_mount": 429,
    "fsopen": 430, "fsconfig": 431, "fsmount": 432, "fspick": 433, "pidfd_open": 434, "clone3": 435, "pidfd_getfd": 438,
    "process_madvise": 440, "mount_setattr": 442, "quotactl_fd": 443, "memfd_secret": 447, "process_mrelease": 448,
    "fchmodat2": 452, "setxattrat": 463, "removexattrat": 466,
    }),
}
