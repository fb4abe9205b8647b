# The same drop with both methods, a quarter of the stable steps (thesis figure 7.2).
load style
set xlabel "time [s]"
set ylabel "height [m]"
set xrange [0:2]
set yrange [-0.06:0.11]
plot 0 linetype 10, \
     folder."/damping.csv" using (strcol("method") eq "CPF" ? column("time_s") : NaN):"height_m" with lines linetype 1 title "CPF", \
     "" using (strcol("method") eq "DPF" ? column("time_s") : NaN):"height_m" with lines linetype 2 title "DPF"
