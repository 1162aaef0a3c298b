# SPDX-License-Identifier: LGPL-2.1-or-later
"""Windows and macOS, simulated: every module is imported there, and what replaces Unix's services is called.

What a simulation cannot show is said in docs/platforms.md.
"""

import importlib.util
import ntpath
import os
import subprocess
import sys
import textwrap
from pathlib import Path

import pytest

from thinpart_workbench.system import file_paths as paths_here

ROOT = Path(__file__).resolve().parents[1]


def on(system, program, *arguments):
    """What a program prints in a process that takes itself for one on another system."""
    start = (f"import sys; sys.path[:0] = [{str(ROOT)!r}, {str(ROOT / 'tests')!r}]\n"
             f"import simulated_system as simulated\nsimulated.use({system!r})\n")
    run = subprocess.run([sys.executable, "-c", start + textwrap.dedent(program), *map(str, arguments)],
                         capture_output=True, encoding="utf-8", timeout=120)
    assert run.returncode == 0, run.stderr
    return run.stdout.split()


IMPORTS = """
import importlib
names = list(simulated.modules())
assert len(names) > 100
for name in names:
    importlib.import_module(name)
print(sys.platform, "fcntl" in sys.modules)
"""


def test_every_module_is_imported_on_windows():
    assert on("win32", IMPORTS) == ["win32", "False"]


def test_every_module_is_imported_on_macos():
    assert on("darwin", IMPORTS)[0] == "darwin"


def test_every_module_that_knows_the_window_asks_only_for_what_all_systems_have():
    # These cannot be imported without FreeCAD. tests/test_layers.py holds the modules that they may import.
    unix = {"os.fork", "os.geteuid", "os.getuid", "os.kill(", "os.killpg", "os.setpriority", "os.mkfifo",
            "signal.SIGHUP", "signal.SIGKILL", "/proc"}
    for file in sorted((ROOT / "thinpart_workbench").rglob("*.py")):
        if "system" not in file.parts:
            text = file.read_text(encoding="utf-8")
            assert not {name for name in unix if name in text}, file


# -- locks


def test_a_lock_on_windows_keeps_others_out_until_it_is_closed(tmp_path):
    told = on("win32", """
        import os, threading, time
        from thinpart_workbench.system.file_lock import lock
        one, two = (os.open(sys.argv[1], os.O_RDWR | os.O_CREAT) for _ in range(2))
        os.write(one, b"ten bytes.")
        lock(one)
        try:
            lock(two)
        except OSError:
            print("refused")
        threading.Timer(0.5, os.close, [one]).start()
        lock(two, 60)
        print("waited", *{(call[1], call[3]) for call in sys.modules["msvcrt"].calls})
    """, tmp_path / "lock")
    assert told == ["refused", "waited", "(2,", "0)"]


def test_a_folder_is_locked_on_windows_without_being_opened_or_written_into(tmp_path):
    (tmp_path / "parts").mkdir()
    told = on("win32", """
        import os, tempfile, threading, time
        from thinpart_workbench.storage.folder_lock import folder_lock
        tempfile.tempdir = sys.argv[2]
        seen = []
        def other():
            with folder_lock(os.path.join(sys.argv[1], ".")):
                seen.append("other")
        with folder_lock(sys.argv[1]):
            thread = threading.Thread(target=other)
            thread.start()
            time.sleep(0.5)
            seen.append("first")
        thread.join()
        print(*seen, len(os.listdir(sys.argv[1])), len(os.listdir(sys.argv[2])))
    """, tmp_path / "parts", tmp_path)
    assert told == ["first", "other", "0", "2"]  # the folder itself, and what stands for it


def test_folders_of_runs_that_were_killed_are_removed_on_windows(tmp_path):
    told = on("win32", """
        import os, tempfile
        tempfile.tempdir = sys.argv[1]
        from thinpart_workbench.storage.temporary_folder import LOCK, PREFIX, temporary_folder
        left = os.path.join(sys.argv[1], PREFIX + "left")
        os.mkdir(left)
        open(os.path.join(left, LOCK), "w").close()
        with temporary_folder() as one:
            print(os.path.exists(left), os.path.exists(os.path.join(one, LOCK)))
            with temporary_folder() as two:
                print(os.path.exists(one))
            print(os.path.exists(two))
        print(os.listdir(sys.argv[1]))
    """, tmp_path)
    assert told == ["False", "True", "True", "False", "[]"]


# -- limits and ends


def test_memory_is_limited_by_a_job_on_windows():
    told = on("win32", """
        import ctypes
        from thinpart_workbench.system import process_limits, windows
        seen = []
        kernel = simulated.KERNEL
        def limits(job, kind, content, size):
            got = ctypes.cast(content, ctypes.POINTER(windows._ExtendedLimits)).contents
            seen.append((job, kind, got.basic.flags, got.process_memory, size))
            return 1
        kernel.SetInformationJobObject = simulated._Function(limits)
        print(process_limits.limit_memory(700 << 20), process_limits.MEMORY_CAN_BE_LIMITED)
        process_limits.crash_quietly()
        print(*seen[0], kernel.named("AssignProcessToJobObject"), kernel.named("SetErrorMode"))
    """)
    # 144 is sizeof(JOBOBJECT_EXTENDED_LIMIT_INFORMATION) on 64 bits.
    assert " ".join(told) == "True True 3000 9 256 734003200 144 [(3000, 18446744073709551615)] [(3,)]"


def test_memory_is_not_limited_on_macos_and_that_is_said():
    assert on("darwin", """
        from thinpart_workbench.system import process_limits
        print(process_limits.limit_memory(700 << 20), process_limits.MEMORY_CAN_BE_LIMITED)
        process_limits.crash_quietly()
    """) == ["False", "False"]


def test_a_process_ends_with_its_parent_by_a_job_on_windows():
    told = on("win32", """
        import os
        from thinpart_workbench.system.parent_death import end_with_parent
        kernel = simulated.KERNEL
        end_with_parent(os.getpid())
        (source, job, receiver, _, _, _, options), = kernel.named("DuplicateHandle")
        print(job, receiver, options, kernel.named("OpenProcess") == [(0x40, False, os.getpid())])
        print(kernel.named("CloseHandle"), flush=True)
        kernel.processes.clear()
        os._exit = lambda status: print("ends with", status)
        end_with_parent(1)
    """)
    assert " ".join(told) == "3000 4000 3 True [(4000,)] ends with 1"


PARENT = """
import os, subprocess, sys
child = subprocess.Popen([sys.executable, "-c", sys.argv[1], str(os.getpid())], stdout=subprocess.PIPE)
print(child.pid, child.stdout.readline().decode().strip(), flush=True)
sys.stdin.read()
"""
CHILD = f"""
import sys, time
sys.path[:0] = [{str(ROOT)!r}, {str(ROOT / 'tests')!r}]
import simulated_system as simulated
simulated.use("darwin")
if sys.argv[2:] == ["poll"]:
    import select
    del select.kqueue
from thinpart_workbench.system.parent_death import end_with_parent
end_with_parent(int(sys.argv[1]))
print("goes on", flush=True)
time.sleep(600)
"""


@pytest.mark.parametrize("how", ["kqueue", "poll"])
def test_a_process_ends_with_its_parent_on_macos(how):
    child = CHILD if how == "kqueue" else CHILD.replace("sys.argv[2:] == [\"poll\"]", "True")
    parent = subprocess.Popen([sys.executable, "-c", PARENT, child], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                              encoding="utf-8")
    number, told = parent.stdout.readline().split(maxsplit=1)
    assert told.strip() == "goes on" and Path(f"/proc/{number}").exists()
    parent.kill()
    parent.communicate()
    from workflow.test_workers import ended

    assert ended(int(number))


# -- pipes, signals, priority


def test_a_pipe_is_looked_into_on_windows():
    assert on("win32", """
        import threading, time
        from thinpart_workbench.system.pipe_input import is_readable
        pipes = simulated.KERNEL.pipes
        pipes[7] = 0
        print(is_readable(7, 0), is_readable(7, 0.1))
        threading.Timer(0.3, pipes.update, [{7: 12}]).start()
        print(is_readable(7, 30), is_readable(7))
        pipes[7] = None
        print(is_readable(7, 0))
    """) == ["False", "False", "True", "True", "True"]


def test_stop_signals_and_ctrl_c_on_windows():
    assert on("win32", """
        import os, signal
        from thinpart_workbench.cli.stop_signals import stop_signals
        from thinpart_workbench.system.interruption import IGNORE_CTRL_C, STOP_SIGNALS, without_ctrl_c
        from thinpart_workbench.core.run_control import RunControl
        print(*map(int, STOP_SIGNALS), IGNORE_CTRL_C)
        control = RunControl()
        with stop_signals(control), without_ctrl_c():
            os.kill(os.getpid(), signal.SIGINT)
        print(control.stopped)
    """) == ["2", "15", "21", "512", "True"]


def test_stepping_back_and_the_user_on_windows():
    assert on("win32", """
        import os
        from thinpart_workbench.system.priority import lower_priority
        from thinpart_workbench.system.user import is_own, is_root
        lower_priority(os.getpid())
        try:
            lower_priority(1)
        except OSError:
            print("gone")
        print(simulated.KERNEL.named("SetPriorityClass"), is_root(), is_own(os.stat("/")))
    """) == ["gone", "[(4000,", "16384)]", "False", "True"]


@pytest.mark.parametrize("system, place", [("win32", "AppData/Local"), ("darwin", "Library/Caches")])
def test_the_cache_lies_where_the_system_has_such_things(system, place, monkeypatch, tmp_path):
    for name in ("XDG_CACHE_HOME", "THINPART_CACHE", "LOCALAPPDATA"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("HOME", str(tmp_path))
    program = "from thinpart_workbench.storage.cache_folder import cache_folder; print(cache_folder())"
    assert on(system, program) == [str(tmp_path / place / "thinpart")]


# -- paths


def as_on_windows(module):
    """A second copy of a module, which found Windows's paths when it was imported."""
    spec = importlib.util.spec_from_file_location(f"{module.__name__}_on_windows", module.__file__)
    copy = importlib.util.module_from_spec(spec)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(os, "path", ntpath)
        spec.loader.exec_module(copy)
    return copy


def test_paths_on_drives_of_windows():
    file_paths = as_on_windows(paths_here)
    assert file_paths.relative_path("C:\\parts\\in\\a.step", "C:\\parts") == "in/a.step"
    assert file_paths.relative_path("C:\\a", "C:\\info\\deep") == "../../a"
    assert file_paths.relative_path("D:\\parts\\a.step", "C:\\parts") == "D:/parts/a.step"
    assert file_paths.path_in_tree("C:\\parts\\in", "C:\\parts") == "in"
    assert file_paths.path_in_tree("D:\\parts\\in", "C:\\") == "D\\parts\\in"
    assert file_paths.path_in_tree("\\\\server\\share\\in", "C:\\") == "server-share\\in"
    assert file_paths.is_below("D:\\parts", "\\") and file_paths.is_below("D:\\parts\\in", "D:\\parts")
    assert not file_paths.is_below("D:\\parts", "C:\\") and not file_paths.is_below("D:\\partsin", "D:\\parts")


def test_paths_here():
    file_paths = paths_here
    assert file_paths.relative_path("/a/b\\c", "/a") == "b\\c"  # a name like others
    assert file_paths.path_in_tree("/a/b", "/") == "a/b" and file_paths.is_below("/a/b", "/")
    assert not file_paths.is_below("/ab", "/a")


def test_a_file_on_windows_is_known_by_size_and_time_alone(tmp_path):
    (tmp_path / "a.thinpart.json").write_text("{}")
    told = on("win32", """
        import os
        from thinpart_workbench.storage.info.info_tree import scan, stamp_of
        found, _ = scan(sys.argv[1])
        print([*found.values()] == [stamp_of(os.stat(os.path.join(sys.argv[1], "a.thinpart.json")))],
              [*found.values()][0].inode)
    """, tmp_path)
    assert told == ["True", "0"]


# -- a worker pool on Windows


def test_workers_take_tasks_time_limits_and_deaths_on_windows(tmp_path):
    program = """
        import os, subprocess
        from thinpart_workbench.workflow.workers.process_pool import ProcessPool
        from worker_outcomes import results
        sys.path.insert(0, os.path.join(sys.path[1], "workflow"))
        import windows_tasks
        begin = subprocess.Popen
        def started(command, creationflags, **options):
            assert creationflags == 0x200
            return begin(command, **options)
        subprocess.Popen = started
        workers = ProcessPool(1, 1.0, sys.argv[1], windows_tasks.do, windows_tasks.start, (os.getpid(),))
        ended = results(workers, ["good 1", "die", "sleep", "good 2"])
        workers.stop()
        print(*sorted(ended), sep="\\n")
    """
    assert " ".join(on("win32", program, tmp_path)) == (
        "('die', 'WorkerDied') ('good 1', 'good 1') ('good 2', 'good 2') ('sleep', 'TimeoutError')")
