"""The sandbox: a hostile program harms nobody, with bubblewrap and, as far as limits go, without."""
import os
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path
from unittest import mock

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import sandbox  # noqa: E402

WORKS = sandbox.sandbox_works
BUBBLE = WORKS()


def sleeping(seconds):
    """The processes that sleep so long."""
    return [line for line in subprocess.run(["ps", "-eo", "args"], capture_output=True, text=True, check=True).stdout.splitlines()
            if line.endswith(f"sleep {seconds}")]


class Limits(unittest.TestCase):
    """What holds on every machine; run once more without bubblewrap below."""
    works = BUBBLE

    def setUp(self):
        patch = mock.patch.object(sandbox, "sandbox_works", return_value=self.works)
        patch.start()
        self.addCleanup(patch.stop)

    def run_shell(self, script, **options):
        return sandbox.run(["sh", "-c", script], "/", limits=sandbox.Limits(**options))

    def test_what_it_says_and_how_it_ends(self):
        done = sandbox.run(["sh", "-c", "cat; echo loud >&2; echo told > {report}; exit 3"], "/", said=b"heard")
        self.assertEqual((done.returncode, done.out, done.err, done.report, done.stopped), (3, "heard", "loud\n", "told\n", ""))

    def test_a_crash_is_told_by_its_signal(self):
        self.assertEqual(self.run_shell("kill -SEGV $$").returncode, -11)

    def test_words_are_words(self):
        name = "x';touch pwned;echo ' \" $HOME ü"
        self.assertEqual(sandbox.run(["printf", "%s", name], "/").out, name)

    def test_time(self):
        start = time.monotonic()
        self.assertEqual(self.run_shell("sleep 60", seconds=0.3).stopped, "time")
        self.assertLess(time.monotonic() - start, 10)

    def test_who_does_not_hear_is_ended_too(self):
        with mock.patch.object(sandbox, "GRACE", 0.3):
            self.assertEqual(self.run_shell("trap '' TERM; while :; do :; done", seconds=0.3).stopped, "time")

    def test_output(self):
        done = self.run_shell("yes", output=10000)
        self.assertEqual((done.stopped, len(done.out)), ("output", 10000))

    def test_memory_of_all_its_processes(self):
        eats = "python3 -c 'x = bytearray(150 << 20); import time; time.sleep(30)'"
        self.assertEqual(self.run_shell(f"{eats} & {eats} & wait", memory=256 << 20).stopped, "memory")

    def test_processes(self):
        self.assertEqual(self.run_shell("for i in 1 2 3 4 5 6 7 8 9; do sleep 30 & done; wait", processes=6).stopped, "processes")

    def test_files(self):
        with tempfile.TemporaryDirectory() as folder:
            sandbox.run(["sh", "-c", "yes > large"], folder, writable=[folder], limits=sandbox.Limits(file=10000))
            self.assertLessEqual(Path(folder, "large").stat().st_size, 10000)

    def test_nobody_is_left_behind_and_nobody_is_waited_for(self):
        start = time.monotonic()
        long = f"4243.{os.getpid()}"  # nobody else's
        self.assertEqual(self.run_shell(f"(setsid sleep {long} &) ; sleep {long} & exit 0").returncode, 0)
        self.assertLess(time.monotonic() - start, 10)
        self.assertEqual(sleeping(long), [])


class WithoutBubblewrap(Limits):
    works = False

    def test_one_line_says_so(self):
        for why, path, variable in (("it is not installed", None, ""), ("ENDURING_SANDBOX=no", "/bin/true", "no"), ("it ends with 1", "/bin/true", "")):
            with mock.patch.object(shutil, "which", return_value=path), mock.patch.dict(os.environ, ENDURING_SANDBOX=variable), \
                    mock.patch.object(sandbox, "bubble", return_value=["false"]), mock.patch("sys.stderr") as told:
                self.assertFalse(WORKS.__wrapped__())
            line, = told.write.call_args[0]
            self.assertIn(why, line)
            self.assertEqual(line.count("\n"), 1)


@unittest.skipUnless(BUBBLE, "bubblewrap cannot run here")
class TheSandbox(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="it's ü "))
        self.addCleanup(shutil.rmtree, self.folder)

    def run_shell(self, script, **options):
        return sandbox.run(["sh", "-c", script], "/", **options)

    def test_it_writes_only_where_it_may(self):
        self.assertNotEqual(self.run_shell(f'touch "{self.folder}/pwned"').returncode, 0)
        self.assertNotEqual(self.run_shell(f'touch "{self.folder}/pwned"', readable=[self.folder]).returncode, 0)
        self.assertNotEqual(self.run_shell("touch /usr/pwned").returncode, 0)
        self.assertEqual(list(self.folder.iterdir()), [])
        self.assertEqual(self.run_shell(f'touch "{self.folder}/mine"', writable=[self.folder]).returncode, 0)
        self.assertEqual([file.name for file in self.folder.iterdir()], ["mine"])

    def test_it_reads_only_what_it_may(self):
        (self.folder / "hidden").write_text("secret", encoding="utf-8")
        self.assertEqual(self.run_shell(f'cat "{self.folder}/hidden"').out, "")
        self.assertEqual(self.run_shell(f"cat {Path.home()}/.* /etc/passwd /etc/shadow").out, "")

    def test_there_is_no_network(self):
        script = "import socket; print([name for _, name in socket.if_nameindex() if name != 'lo'])"
        self.assertEqual(sandbox.run(["python3", "-c", script], "/").out, "[]\n")

    def test_it_sees_no_other_process_and_not_our_environment(self):
        with mock.patch.dict(os.environ, TOKEN="secret"):
            self.assertNotIn("secret", self.run_shell("env; cat /proc/*/environ").out)


if __name__ == "__main__":
    unittest.main()
