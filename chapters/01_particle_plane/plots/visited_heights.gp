# Heights still visited after thousands of steps, over the step: one dot where the particle rests.
height = 520
load style
set multiplot layout 2,1 margins 0.12,0.98,0.135,0.98 spacing 0,0.05
set xrange [0:0.18]
set yrange [-0.2:0.5]
set ytics -0.2,0.2
set ylabel "height [m]"
set key top left
set format x ""
plot 0 linetype 10, folder."/visited_heights.csv" using "dt_s":(strcol("method") eq "DPF" ? column("height_m") : NaN) \
     with points linetype 2 pointtype 7 pointsize 0.16 title "DPF"
set format x "%.2f"
set xlabel "step Δt [s]"
plot 0 linetype 10, folder."/visited_heights.csv" using "dt_s":(strcol("method") eq "CPF" ? column("height_m") : NaN) \
     with points linetype 1 pointtype 7 pointsize 0.16 title "CPF"
unset multiplot
