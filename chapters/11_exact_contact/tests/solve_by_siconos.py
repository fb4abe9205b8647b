#!/usr/bin/python3
"""Reads a problem of bodies by Siconos and solves it: solve_by_siconos.py FILE COORDINATES prints its impulses, a number for each of r.

Ends with 3 where Siconos or scipy is not installed (on Debian 12: ./course setup siconos).
"""
import sys

try:
    import numpy
    import scipy.sparse  # noqa: F401  Siconos' own matrices need it to be there
    import siconos.numerics as sn
except ImportError:
    sys.exit(3)

problem = sn.globalFrictionContact_new_from_filename(sys.argv[1])
contacts = problem.numberOfContacts
impulses, velocities = numpy.zeros(3 * contacts), numpy.zeros(3 * contacts)
options = sn.SolverOptions(sn.SICONOS_GLOBAL_FRICTION_3D_NSGS_WR)
options.dparam[sn.SICONOS_DPARAM_TOL] = 1e-10
options.iparam[sn.SICONOS_IPARAM_MAX_ITER] = 100000
unsolved = sn.gfc3d_driver(problem, impulses, velocities, numpy.zeros(int(sys.argv[2])), options)
print(*(repr(float(x)) for x in impulses))
sys.exit(1 if unsolved else 0)
