"""Commands that run at once wait for each other."""
import fcntl
import sys
from contextlib import contextmanager


@contextmanager
def alone(folder, what=""):
    """One at a time in a folder: who comes second waits, and says so once it does.
    @param what  what is done there; without it, waiting is not told"""
    folder.mkdir(parents=True, exist_ok=True)
    with (folder / ".lock").open("w", encoding="utf-8") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            if what:
                print(f"Another command is {what}; waiting for it.", file=sys.stderr, flush=True)
            fcntl.flock(lock, fcntl.LOCK_EX)
        yield
