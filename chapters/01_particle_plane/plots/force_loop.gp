# Force over height during the first visit to the ground: the area inside a loop is the energy that the visit costs.
load style
set xlabel "height, half a step back [m]"
set ylabel "mean force of the step [N]"
set xrange [-0.055:0.012]
set yrange [-2:60]
set key top right
plot (x < 0 ? -1000*x : 0) linetype 10 title "the spring itself", \
     folder."/force_loop.csv" using (strcol("method") eq "CPF" ? column("height_m") : NaN):"force_n" with linespoints linetype 1 title "CPF", \
     "" using (strcol("method") eq "DPF" ? column("height_m") : NaN):"force_n" with linespoints linetype 2 title "DPF"
