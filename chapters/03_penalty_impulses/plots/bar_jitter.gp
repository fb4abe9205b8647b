# Jitter at rest over the step: the median of nine drops, and the span from the smoothest to the roughest. Above quadratic elements, below linear ones.
height = 640
load style
set multiplot layout 2,1 margins 0.12,0.98,0.105,0.98 spacing 0,0.03
set logscale y
set ylabel "jitter [% of the weight]"
set yrange [0.01:60]
set xrange [0.0048:0.0142]
set key top left
of(e, m, x) = strcol("elements") eq e && strcol("method") eq m ? x : NaN
do for [e in "quadratic linear"] {
    set format x (e eq "linear" ? "%g" : "")
    set xlabel (e eq "linear" ? "step Δt [s]" : "")
    set label 1 e." elements" at graph 0.98,0.08 right textcolor rgb ink
    plot 0.3 linetype 10 notitle, \
         folder."/bar_jitter.csv" using "dt_s":(of(e, "DPF", column("smallest_percent"))):"largest_percent" with filledcurves linetype 2 fillstyle transparent solid 0.15 notitle, \
         "" using "dt_s":(of(e, "CPF", column("smallest_percent"))):"largest_percent" with filledcurves linetype 1 fillstyle transparent solid 0.15 notitle, \
         "" using "dt_s":(of(e, "DPF", column("median_percent"))) with linespoints linetype 2 title "DPF", \
         "" using "dt_s":(of(e, "CPF", column("median_percent"))) with linespoints linetype 1 title "CPF"
}
unset multiplot
