# Chung and Ooi's fourth test without a rebound: lines are the formulas, points the runs.
load style
set xlabel "angle between the velocity and the ground's normal [°]"
set ylabel "velocity after the impact [m/s]"
set xrange [0:90]
set key above maxcols 2
data = folder."/spheres.csv"
of(name) = strcol("test")[1:1] eq "4" && column("dt_s") > 4e-4 ? column(name) : NaN
plot 0 linetype 10, \
     data using "varied":(of("by_formula_m_per_s")) with lines linetype 1 title "of the centre, along the ground: formula", \
     data using "varied":(of("along_m_per_s")) with points linetype 1 pointtype 6 pointsize 1 title "run", \
     data using "varied":(of("rim_by_formula_m_per_s")) with lines linetype 2 title "spin times radius: formula", \
     data using "varied":(of("rim_m_per_s")) with points linetype 2 pointtype 4 pointsize 1 title "run"
