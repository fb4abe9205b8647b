"""Packages from npm, in the versions and with the digests of a package-lock.json of ours."""
import shutil
import subprocess


def installed(given, work):
    """Whether what a folder's package-lock.json names lies in work/node_modules; where it does not and npm is there, npm fetches it.
    @param given  folder with package.json and package-lock.json"""
    lock, kept = given / "package-lock.json", work / "package-lock.json"
    if (work / "node_modules").is_dir() and kept.is_file() and kept.read_bytes() == lock.read_bytes():
        return True
    if not shutil.which("npm"):
        return False
    work.mkdir(parents=True, exist_ok=True)
    for name in ("package.json", lock.name):
        shutil.copyfile(given / name, work / name)
    done = subprocess.run(["npm", "ci", "--ignore-scripts", "--no-audit", "--no-fund", "--silent", "--prefix", str(work)], check=False)
    if done.returncode:
        kept.unlink()  # the next time it is tried again
    return done.returncode == 0
