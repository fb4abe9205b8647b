# Inertia of a square bar about its own axis over the integral, against how many cells it is thick.
load style
set key top right
set xlabel "cells across the bar"
set ylabel "inertia over the integral"
set xrange [0.8:6.2]
set yrange [0.8:3.1]
set xtics 1
data = folder."/inertia_over_cells.csv"
plot data using "cells_across":"linear" with linespoints linetype 2 title "lumped masses, linear elements", \
     data using "cells_across":"quadratic" with linespoints linetype 4 title "lumped masses, quadratic elements", \
     data using "cells_across":"consistent" with linespoints linetype 1 title "mass matrix, either"
