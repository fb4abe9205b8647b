# The cube on the soft bar: its speed, and the force of the bar on it (thesis figure 7.12), with and without redefinition.
height = 560
load style
set multiplot layout 2,1 margins 0.12,0.98,0.125,0.97 spacing 0,0.04
set xrange [0:2.8]
on(s, x) = strcol("solver") eq s ? x : NaN
set format x ""
set ylabel "speed [m/s]"
set key center right
plot 0 linetype 10 notitle, \
     folder."/sliding_bar.csv" using "time_s":(on("chapter 6", column("speed_m_per_s"))) with lines linetype 1 title "chapter 6", \
     "" using "time_s":(on("chapter 5", column("speed_m_per_s"))) with lines linetype 2 title "chapter 5"
set format x "%g"
set xlabel "time [s]"
set ylabel "force upwards [N]"
set yrange [0:450]
unset key
plot 196.2 linetype 10, \
     folder."/sliding_bar.csv" using "time_s":(on("chapter 5", column("force_n"))) with lines linetype 2 linewidth 0.7, \
     "" using "time_s":(on("chapter 6", column("force_n"))) with lines linetype 1 linewidth 0.9
unset multiplot
