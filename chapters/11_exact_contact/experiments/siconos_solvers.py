#!/usr/bin/python3
"""Solves contact problems by solvers of Siconos (Debian 12: python3-siconos).

siconos_solvers.py FOLDER TOLERANCE: for each problem of the folder (*.dat, in three dimensions, W in blocks) and each solver a line
    answer SOLVER FILE SECONDS STEPS r...
with processor time of the solver alone, the least of some runs. Ends with 3 where Siconos is not installed, and with 1 where an answer is lost.
"""
import os
import pathlib
import signal
import sys
import time

try:
    import numpy
    import siconos.numerics as sn
except ImportError:
    sys.exit(3)

# The solvers that V. Acary, M. Bremond and O. Huber compare (On solving contact problems with Coulomb friction: formulations and numerical
# comparisons, 2018), each with the settings that solved most of the problems here, of ten that were tried: Newton's method on Alart and
# Curnier's equations solves more than on Fischer and Burmeister's, and ADMM more if it balances scaled residuals. Gauss-Seidel solves as many
# with projections as with Newton's method in each contact, its default.
NEWTON_STEPS, OTHER_STEPS = 500, 10000
MOST_SECONDS = 20  # of processor time


def nsgs():
    options = sn.SolverOptions(sn.SICONOS_FRICTION_3D_NSGS)  # contact by contact, each by Newton's method
    options.iparam[sn.SICONOS_IPARAM_MAX_ITER] = OTHER_STEPS
    return options


def newton():
    options = sn.SolverOptions(sn.SICONOS_FRICTION_3D_NSN_AC)  # all contacts together
    options.iparam[sn.SICONOS_IPARAM_MAX_ITER] = NEWTON_STEPS
    return options


def admm():
    options = sn.SolverOptions(sn.SICONOS_FRICTION_3D_ADMM)
    options.iparam[sn.SICONOS_IPARAM_MAX_ITER] = OTHER_STEPS
    options.iparam[sn.SICONOS_FRICTION_3D_ADMM_IPARAM_RHO_STRATEGY] = sn.SICONOS_FRICTION_3D_ADMM_RHO_STRATEGY_SCALED_RESIDUAL_BALANCING
    return options


def solve(file, make, tolerance):
    problem = sn.frictionContact_new_from_filename(str(file))
    numbers = 3 * problem.numberOfContacts
    best = None
    for _ in range(3):
        impulses, velocities, options = numpy.zeros(numbers), numpy.zeros(numbers), make()
        options.dparam[sn.SICONOS_DPARAM_TOL] = tolerance
        begin = time.process_time()
        sn.fc3d_driver(problem, impulses, velocities, options)
        seconds = time.process_time() - begin
        best = seconds if best is None else min(best, seconds)
        if seconds > 0.05:
            break
    return best, options.iparam[sn.SICONOS_IPARAM_ITER_DONE], impulses


def processor_seconds(process):
    """What a process has had: what other programs take on a loaded machine does not count."""
    numbers = pathlib.Path(f"/proc/{process}/stat").read_text(encoding="ascii").rpartition(")")[2].split()
    return (int(numbers[11]) + int(numbers[12])) / os.sysconf("SC_CLK_TCK")


def wait_for(process):
    """Ends what takes too long. Siconos ends by a signal, too; any other code is an answer that is lost."""
    while (ended := os.waitpid(process, os.WNOHANG)) == (0, 0):
        if processor_seconds(process) > MOST_SECONDS:
            os.kill(process, signal.SIGKILL)
        time.sleep(0.005)
    if os.WIFEXITED(ended[1]) and os.WEXITSTATUS(ended[1]):
        sys.exit(1)


def print_answer(name, file, make, tolerance):
    """In a process of its own: Siconos' Newton ends the whole program where an assertion fails."""
    if child := os.fork():
        wait_for(child)
        return
    seconds, steps, impulses = solve(file, make, tolerance)
    print("answer", name, file.name, repr(seconds), steps, *(repr(float(x)) for x in impulses), flush=True)
    os._exit(0)


if __name__ == "__main__":
    for file in sorted(pathlib.Path(sys.argv[1]).glob("*.dat")):
        for name, make in (("NSGS", nsgs), ("Newton", newton), ("ADMM", admm)):
            print_answer(name, file, make, float(sys.argv[2]))
