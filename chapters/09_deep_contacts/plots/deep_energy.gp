# Kinetic energy of the cube that rams the block, over that at first.
load style
set xlabel "time [s]"
set ylabel "kinetic energy over that at first"
set xrange [0:0.4]
set yrange [0:2.6]
set key above
of(name) = strcol("solver") eq name ? column("energy_ratio") : NaN
data = folder."/deep_energy.csv"
plot 1 linetype 10, \
     data using "time_s":(of("chapter 6")) with linespoints linetype 2 title "chapter 6", \
     data using "time_s":(of("chapter 9")) with linespoints linetype 1 title "chapter 9"
