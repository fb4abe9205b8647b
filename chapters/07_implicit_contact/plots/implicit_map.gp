# The spectral radius of the implicit step over h = k dt^2 / m, for weights with different centres.
load style
set logscale x
set format x "10^{%L}"
set xlabel "stiffness of the step, h = k Δt^2/m"
set ylabel "spectral radius"
set xrange [0.01:10000]
set yrange [0:1.6]
set key above
of(a) = abs(column("centre") - a) < 0.01 ? column("spectral_radius") : NaN
map = folder."/implicit_map.csv"
plot 1 linetype 10, \
     map using "h":(of(0.25)) with lines linetype 5 title "centre 1/4", \
     map using "h":(of(0.5)) with lines linetype 1 title "1/2: CPF", \
     map using "h":(of(2.0/3)) with lines linetype 3 title "2/3", \
     map using "h":(of(0.8)) with lines linetype 4 title "4/5", \
     map using "h":(of(1.0)) with lines linetype 2 title "1: DPF", \
     map using "h":(abs(column("centre") - 0.5) < 0.01 ? column("measured") : NaN) with points linetype 1 pointtype 6 notitle
