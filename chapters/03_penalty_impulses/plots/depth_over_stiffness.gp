# Summed depth at rest and jitter over the stiffness at dt = 0.01 s, quadratic elements (thesis figure 7.7).
height = 560
load style
set multiplot layout 2,1 margins 0.12,0.98,0.125,0.97 spacing 0,0.04
set xrange [1900:10500]
set logscale x
set key top right
of(m, x) = strcol("elements") eq "quadratic" && strcol("method") eq m ? x : NaN
set format x ""
set ylabel "summed depth [mm]"
set yrange [0:*]
plot folder."/depth_over_stiffness.csv" using "stiffness_n_per_m":(of("CPF", column("depth_mm"))) with linespoints linetype 1 title "CPF", \
     "" using "stiffness_n_per_m":(of("DPF", column("depth_mm"))) with linespoints linetype 2 title "DPF"
set format x "%g"
set xlabel "stiffness of a pair k [N/m]"
set ylabel "jitter [% of the weight]"
set logscale y
set yrange [0.01:60]
unset key
plot 0.3 linetype 10, \
     folder."/depth_over_stiffness.csv" using "stiffness_n_per_m":(of("CPF", column("jitter_percent"))) with linespoints linetype 1, \
     "" using "stiffness_n_per_m":(of("DPF", column("jitter_percent"))) with linespoints linetype 2
unset multiplot
