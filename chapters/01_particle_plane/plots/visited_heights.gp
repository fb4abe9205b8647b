# Heights still visited after thousands of steps, over the step: one dot where the particle rests.
height = 520
load style
set multiplot layout 2,1 margins 0.12,0.98,0.135,0.98 spacing 0,0.05
set xrange [0:0.18]
set yrange [-0.2:0.5]
set ytics -0.2,0.2
set ylabel "height [m]"
unset key
set format x ""
set label 1 "DPF" at graph 0.02,0.9 textcolor linetype 2
plot 0 linetype 10, folder."/visited_heights.csv" using "dt_s":(strcol("method") eq "DPF" ? column("height_m") : NaN) \
     with points linetype 2 pointtype 7 pointsize 0.16
set format x "%.2f"
set xlabel "step Δt [s]"
set label 1 "CPF" at graph 0.02,0.9 textcolor linetype 1
plot 0 linetype 10, folder."/visited_heights.csv" using "dt_s":(strcol("method") eq "CPF" ? column("height_m") : NaN) \
     with points linetype 1 pointtype 7 pointsize 0.16
unset multiplot
