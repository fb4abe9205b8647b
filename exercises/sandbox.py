"""Runs what nobody trusts: without a shell, in a sandbox (bubblewrap), with limits, and with nothing of it left behind.

Inside there is no network, nothing of the user's but what is named, and nothing to write to but what is named and a /tmp of its own. Where
bubblewrap cannot run (a container, a kernel without user namespaces) the limits stay, and one line says so.
"""
import contextlib
import functools
import os
import secrets
import selectors
import shutil
import signal
import subprocess
import sys
import time
from dataclasses import dataclass, field
from pathlib import Path

SYSTEM = ("/usr", "/bin", "/sbin", "/lib", "/lib32", "/lib64", "/opt", "/etc/alternatives", "/etc/fonts", "/etc/ld.so.cache")
MARK = "ENDURING_MARK"    # in the environment of all that a run starts: so it is found again
LOOK = 0.1                # seconds between two looks at what a run uses
GRACE = 3                 # seconds for a report, once asked to end
WARNING = "course: bubblewrap cannot run here ({}): answers run with limits, but may read and write what you may.\n"


@dataclass(frozen=True)
class Limits:
    """What a run may use; of bytes and processes, all that it starts together."""
    seconds: float = 20
    memory: int = 4 << 30
    output: int = 1 << 20     # bytes of each stream
    file: int = 256 << 20     # bytes of each file it writes
    processes: int = 64


@dataclass
class Finished:
    """How a run ended. `stopped` names the limit that it met: time, memory, output or processes."""
    returncode: int
    out: str
    err: str
    report: str
    stopped: str = ""


@dataclass
class Running:
    """A run on its way: what it has written so far, by the end of each pipe that we read."""
    process: subprocess.Popen
    mark: bytes
    limits: Limits
    written: dict
    selector: selectors.BaseSelector = field(default_factory=selectors.DefaultSelector)

    def read(self, wait):
        """Reads what is there. @return whether a stream is longer than it may be"""
        for key, _ in self.selector.select(wait):
            chunk = os.read(key.fd, 1 << 16)
            if not chunk:
                self.selector.unregister(key.fd)
            self.written[key.fd] += chunk
        return any(len(stream) > self.limits.output for stream in self.written.values())

    def met(self):
        """The limit of memory or of processes that it has met, or nothing."""
        marked = marked_processes(self.mark)
        if len(marked) > self.limits.processes:
            return "processes"
        return "memory" if sum(map(resident, marked)) > self.limits.memory else ""


def run(command, cwd, readable=(), writable=(), limits=Limits(), said=b"", environment=None, trusted=False):
    """Runs a command to its end, or to the first limit that it meets.

    @param command   its words; "{report}" in one of them becomes a file that is read as its report
    @param readable  files and folders that it sees, beside the system's
    @param writable  folders that it may write to
    @param said      what it reads from its standard input
    @param trusted   the course's own: without the sandbox, with the limits
    @return Finished"""
    mark, pipes = secrets.token_hex(16), [os.pipe() for _ in range(4)]
    (input_end, input_ours), *outputs = pipes
    words = [str(word).replace("{report}", f"/proc/self/fd/{outputs[2][1]}") for word in command]
    words = ["prlimit", f"--as={limits.memory}", f"--fsize={limits.file}", "--core=0", "--", *words]
    known = dict(os.environ) if trusted else {"PATH": "/usr/local/bin:/usr/bin:/bin", "LC_ALL": "C.UTF-8", "HOME": "/tmp"}
    known |= {MARK: mark} | (environment or {})
    if not trusted and sandbox_works():
        words = bubble(cwd, readable, writable, known) + words
        known = {"PATH": known["PATH"]}  # bubblewrap itself bears no mark: it would take SIGTERM for itself
    try:
        process = subprocess.Popen(words, cwd=cwd, stdin=input_end, stdout=outputs[0][1], stderr=outputs[1][1], env=known,
                                   pass_fds=[outputs[2][1]], start_new_session=True)
        for given in (input_end, *(theirs for _, theirs in outputs)):
            os.close(given)
        running = Running(process, f"{MARK}={mark}".encode(), limits, {ours: b"" for ours, _ in outputs})
        with contextlib.suppress(BrokenPipeError):
            os.write(input_ours, said)
        os.close(input_ours)
        for ours in running.written:
            running.selector.register(ours, selectors.EVENT_READ)
        try:
            stopped = watch(running)
        finally:
            end_all(running)
        end = time.monotonic() + GRACE
        while running.selector.get_map() and not running.read(LOOK) and time.monotonic() < end:  # what was written before the end
            pass
        out, err, report = (stream[:limits.output].decode(errors="replace") for stream in running.written.values())
        killed = process.returncode - 128  # as bubblewrap and shells tell a signal
        return Finished(-killed if 0 < killed <= signal.SIGRTMAX else process.returncode, out, err, report, stopped)
    finally:
        for ours, _ in outputs:
            os.close(ours)


def watch(running):
    """Follows a run until it ends or meets a limit. Who runs out of time is asked to end first, so that its report says where it was.
    @return the limit, or nothing"""
    start = look = time.monotonic()
    stopped = ""
    while running.process.poll() is None:
        if running.read(LOOK / 2):
            return stopped or "output"
        now = time.monotonic()
        if not stopped and now - start > running.limits.seconds:
            stopped, start = "time", now
            send(running, signal.SIGTERM)
        elif stopped and now - start > GRACE:
            return stopped
        elif now - look > LOOK:
            look = now
            if met := running.met():
                return stopped or met
    return stopped


def end_all(running):
    """Ends a run and all that it has started, also what has left its process group."""
    with contextlib.suppress(ProcessLookupError):
        os.killpg(running.process.pid, signal.SIGKILL)
    running.process.wait()
    while send(running, signal.SIGKILL):
        time.sleep(LOOK / 10)


def send(running, number):
    """@return how many processes were sent this signal"""
    marked = marked_processes(running.mark)
    for process in marked:
        with contextlib.suppress(ProcessLookupError):
            os.kill(process, number)
    return len(marked)


def marked_processes(mark):
    """The processes with this mark in their environment."""
    found = []
    for folder in Path("/proc").glob("[0-9]*"):
        with contextlib.suppress(OSError):
            if mark in (folder / "environ").read_bytes():
                found.append(int(folder.name))
    return found


def resident(process):
    """Bytes of memory that a process uses."""
    with contextlib.suppress(OSError, ValueError, IndexError):
        return int(Path(f"/proc/{process}/statm").read_text(encoding="ascii").split()[1]) * os.sysconf("SC_PAGESIZE")
    return 0


def bubble(cwd, readable, writable, environment):
    """The words of bubblewrap before a command."""
    words = ["bwrap", "--unshare-all", "--die-with-parent", "--new-session", "--cap-drop", "ALL", "--clearenv", "--proc", "/proc", "--dev", "/dev",
             "--size", str(1 << 30), "--tmpfs", "/tmp"]
    for path in (*SYSTEM, *readable):
        words += ["--ro-bind-try", str(path), str(path)]
    for path in writable:
        words += ["--bind", str(path), str(path)]
    for name, value in environment.items():
        words += ["--setenv", name, value]
    return [*words, "--chdir", str(cwd), "--"]


@functools.cache
def sandbox_works():
    """Whether bubblewrap can run here; if not, says so once. ENDURING_SANDBOX=no is for those who are in a container already."""
    why = "it is not installed" if not shutil.which("bwrap") else "ENDURING_SANDBOX=no" if os.environ.get("ENDURING_SANDBOX") == "no" else ""
    if not why:
        done = subprocess.run([*bubble("/", (), (), {}), "true"], capture_output=True, text=True, errors="replace")
        if done.returncode == 0:
            return True
        why = done.stderr.strip().split("\n")[-1] or f"it ends with {done.returncode}"
    sys.stderr.write(WARNING.format(why))
    return False
