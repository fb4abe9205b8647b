# Error of the impulse by the constant length L_k, over how far the face turns or grows in one step.
height = 380
load style
set multiplot layout 1,2 margins 0.11,0.99,0.19,0.95 spacing 0.04,0
set logscale xy
set yrange [1e-6:100]
set format y "10^{%T}"
set key top left
set ylabel "error of the impulse [%]"
set xlabel "turn of the face in one step [degrees]"
set xrange [0.2:120]
turned(x) = column("turn_deg") > 0 ? x : NaN
grown(x) = column("growth_percent") > 0 ? x : NaN
plot folder."/normalisation.csv" using "turn_deg":(turned(column("max_percent"))) with linespoints linetype 2 title "largest", \
     "" using "turn_deg":(turned(column("p95_percent"))) with linespoints linetype 1 title "95 of 100", \
     "" using "turn_deg":(turned(column("median_percent"))) with linespoints linetype 3 title "half", \
     4e-4*x**2 with lines linetype 10 title "turn²"
set ylabel ""
set format y ""
set xlabel "growth of the face in one step [%]"
set xrange [0.07:140]
unset key
plot folder."/normalisation.csv" using "growth_percent":(grown(column("max_percent"))) with linespoints linetype 2, \
     "" using "growth_percent":(grown(column("p95_percent"))) with linespoints linetype 1, \
     "" using "growth_percent":(grown(column("median_percent"))) with linespoints linetype 3
unset multiplot
