# Mean summed penetration depth along k dt^2 = const, quadratic elements (thesis figure 7.6).
load style
set xlabel "step Δt [s]"
set ylabel "summed depth [mm]"
set xrange [0:0.0105]
set yrange [0:*]
set key top left
of(x) = strcol("elements") eq "quadratic" ? x : NaN
plot folder."/depth_over_step.csv" using "dt_s":(of(column("cpf_depth_mm"))) with linespoints linetype 1 title "CPF", \
     "" using "dt_s":(of(column("dpf_depth_mm"))) with linespoints linetype 2 title "DPF"
