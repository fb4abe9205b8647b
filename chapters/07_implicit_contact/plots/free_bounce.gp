# Chapter 1's drop again: explicit, implicit with the end's velocity, implicit with the mean of both.
load style
set xlabel "time [s]"
set ylabel "height [m]"
set xrange [0:2]
set yrange [-0.06:0.11]
set key above
of(name) = strcol("method") eq name ? column("height_m") : NaN
data = folder."/free_bounce.csv"
plot 0 linetype 10, \
     data using "time_s":(of("explicit")) with lines linetype 2 title "chapter 1's CPF", \
     data using "time_s":(of("end velocity")) with lines linetype 3 title "implicit, end velocity", \
     data using "time_s":(of("mean velocity")) with lines linetype 1 title "implicit, mean velocity"
