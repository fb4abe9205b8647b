# What becomes of the energy of a double pendulum, for three steps.
load style
set xlabel "time [s]"
set ylabel "change of energy [% of m g h]"
set key above
data = folder."/double_pendulum_energy.csv"
plot data using "time_s":"percent_10_ms" with lines linetype 1 title "10 ms", \
     data using "time_s":"percent_5_ms" with lines linetype 2 title "5 ms", \
     data using "time_s":"percent_2_5_ms" with lines linetype 3 title "2.5 ms"
