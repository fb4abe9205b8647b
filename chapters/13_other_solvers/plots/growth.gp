# A line a method: processor time of a step over the number of cubes that have fallen on one another.
load style
set logscale xy
set key outside right
set xlabel "cubes"
set ylabel "time of a step [ms]"
data = folder."/growth.csv"
methods = "'sequential impulses' 'soft step' 'convex relaxation' XPBD AVBD barrier 'chapter 10'"
of(method, value) = strcol("method") eq method ? value : NaN
plot for [i=1:words(methods)] data using "cubes":(of(word(methods, i), column("step_ms_by_clock"))) with linespoints linetype i pointtype 4 + i pointsize 0.7 title word(methods, i)
