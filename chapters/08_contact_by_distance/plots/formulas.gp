# The relative error of all motions with a formula over the step; thin lines: in proportion to the step, and to its square.
height = 620
load style
set logscale xy
set format y "10^{%L}"
set xlabel "step Δt [ms]"
set ylabel "relative error"
set xrange [*:10.5] noextend
set yrange [1e-6:2]
set xtics (0.625, 1.25, 2.5, 5, 10)
set key outside below maxcols 3 samplen 2 font ",11"
curves = folder."/formulas_curves.csv"
stats curves skip 1 using 1 nooutput
stats curves skip 1 matrix nooutput
count = int(STATS_size_x)
dash(i) = i < 8 ? 1 : i < 14 ? 3 : 4
plot 0.002 * x with lines linetype 10, 0.0005 * x ** 2 / 8 with lines linetype 10, \
     for [i = 2:count] curves using (1000 * column(1)):i with linespoints linetype ((i - 2) % 6 + 1) dashtype dash(i) \
     title columnheader(i)
