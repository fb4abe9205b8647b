# A line a method: how far a stack of ten and a cube on a slope have moved after a second, over iterations, substeps or steps.
height = 640
load style
set multiplot layout 2,1 margins 0.13,0.70,0.11,0.98 spacing 0,0.12
set logscale xy
set format y "10^{%L}"
set xrange [0.9:300]
set key outside right
data = folder."/over_iterations.csv"
methods = "'sequential impulses' 'soft step' 'convex relaxation' XPBD AVBD barrier"
of(method, value) = strcol("method") eq method ? value : NaN
set ylabel "stack of ten: moved [m]"
plot for [i=1:words(methods)] data using "n":(of(word(methods, i), column("stack_m"))) with linespoints linetype i pointtype 4 + i pointsize 0.7 title word(methods, i)
set ylabel "slope of 20°: moved [m]"
set xlabel "n: iterations, substeps or steps of Newton's method"
plot for [i=1:words(methods)] data using "n":(of(word(methods, i), column("slope_m"))) with linespoints linetype i pointtype 4 + i pointsize 0.7 title word(methods, i)
unset multiplot
