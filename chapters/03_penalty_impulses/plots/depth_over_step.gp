# Mean summed penetration depth along k dt^2 = const (thesis figure 7.6).
load style
set xlabel "step Δt [s]"
set ylabel "summed depth [mm]"
set xrange [0:0.021]
set yrange [0:*]
set key top left
plot folder."/depth_over_step.csv" using "dt_s":"cpf_depth_mm" with linespoints linetype 1 title "CPF", \
     "" using "dt_s":"dpf_depth_mm" with linespoints linetype 2 title "DPF"
