# The spectral radius over the step; filled where the simulation settles, open where it does not.
load style
set xlabel "step Δt [s]"
set ylabel "spectral radius"
set xrange [0:0.18]
set yrange [0:2.2]
set key top left
at_rest(name, m) = strcol("method") eq m && strcol("simulated") eq name ? column("spectral_radius") : NaN
set arrow 1 from first sqrt(4.0/300), graph 0 to first sqrt(4.0/300), graph 1 nohead linetype 2 linewidth 0.7 dashtype 2
set arrow 2 from first sqrt(0.02), graph 0 to first sqrt(0.02), graph 1 nohead linetype 1 linewidth 0.7 dashtype 2
plot 1 linetype 10, \
     folder."/stability_map.csv" using "dt_s":(at_rest("settles", "DPF")) with points linetype 2 title "DPF settles", \
     "" using "dt_s":(at_rest("keeps bouncing", "DPF")) with points linetype 2 pointtype 4 title "DPF keeps bouncing", \
     "" using "dt_s":(at_rest("settles", "CPF")) with points linetype 1 title "CPF settles", \
     "" using "dt_s":(at_rest("keeps bouncing", "CPF")) with points linetype 1 pointtype 6 title "CPF keeps bouncing"
