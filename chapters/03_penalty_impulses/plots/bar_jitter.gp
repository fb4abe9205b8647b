# Jitter at rest over the step: the median of nine drops, and the span from the smoothest to the roughest.
load style
set logscale y
set xlabel "step Δt [s]"
set ylabel "jitter [% of the weight]"
set yrange [0.01:60]
set xrange [0.0068:0.0142]
set key top left
of(m, x) = strcol("method") eq m ? x : NaN
plot 0.3 linetype 10, \
     folder."/bar_jitter.csv" using "dt_s":(of("DPF", column("smallest_percent"))):"largest_percent" with filledcurves linetype 2 fillstyle transparent solid 0.15, \
     "" using "dt_s":(of("CPF", column("smallest_percent"))):"largest_percent" with filledcurves linetype 1 fillstyle transparent solid 0.15, \
     "" using "dt_s":(of("DPF", column("median_percent"))) with linespoints linetype 2 title "DPF", \
     "" using "dt_s":(of("CPF", column("median_percent"))) with linespoints linetype 1 title "CPF"
