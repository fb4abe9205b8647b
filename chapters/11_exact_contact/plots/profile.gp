# How many of the public problems are solved within so many steps of Newton's method.
load style
set xlabel "steps of Newton's method"
set ylabel "problems solved [%]"
set logscale x
set xrange [1:1000]
set yrange [0:105]
set key above
data = folder."/profile.csv"
plot data using "newton_steps":"to_1e-4_percent" with linespoints linetype 1 title "to 10^{-4}", \
     data using "newton_steps":"to_1e-6_percent" with linespoints linetype 2 title "to 10^{-6}", \
     data using "newton_steps":"to_1e-8_percent" with linespoints linetype 3 title "to 10^{-8}"
