# A cube pushed up a slope (thesis figure 7.15): the printed constants in two readings, and mass-splitting friction.
height = 520
load style
set multiplot layout 2,1 margins 0.12,0.98,0.135,0.97 spacing 0,0.04
set xrange [0:4]
set key bottom left
on(s, x) = strcol("series") eq s ? x : NaN
set format x ""
set ylabel "way [m]"
set yrange [-3.5:2]
plot 0 linetype 10, folder."/slope.csv" using "time_s":(on("as impulse 0.3", column("distance_m"))) with lines linetype 2 title "5.22 as an impulse, 0.3", \
     "" using "time_s":(on("as impulse 0.4", column("distance_m"))) with lines linetype 2 dashtype 2 title "the same, 0.4", \
     "" using "time_s":(on("as printed 0.3", column("distance_m"))) with lines linetype 3 title "5.22 in SI units, 0.3", \
     "" using "time_s":(on("mass splitting 0.16", column("distance_m"))) with lines linetype 1 dashtype 2 title "mass splitting, 0.16", \
     "" using "time_s":(on("mass splitting 0.4", column("distance_m"))) with lines linetype 1 title "mass splitting, 0.4"
set format x "%g"
set xlabel "time [s]"
set ylabel "speed [m/s]"
unset key
set yrange [-4:3.2]
plot 0 linetype 10, folder."/slope.csv" using "time_s":(on("as impulse 0.3", column("speed_m_per_s"))) with lines linetype 2, \
     "" using "time_s":(on("as impulse 0.4", column("speed_m_per_s"))) with lines linetype 2 dashtype 2, \
     "" using "time_s":(on("as printed 0.3", column("speed_m_per_s"))) with lines linetype 3, \
     "" using "time_s":(on("mass splitting 0.16", column("speed_m_per_s"))) with lines linetype 1 dashtype 2, \
     "" using "time_s":(on("mass splitting 0.4", column("speed_m_per_s"))) with lines linetype 1
unset multiplot
