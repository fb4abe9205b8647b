# The cube that friction stops on the soft bar: where it is and how fast.
height = 520
load style
set multiplot layout 2,1 margins 0.12,0.98,0.125,0.97 spacing 0,0.05
set xrange [0:3]
on(mu, x) = column("mu_static") == mu ? x : NaN
set format x ""
set ylabel "x [m]"
set key bottom right
plot folder."/bar_friction.csv" using "time_s":(on(0.4, column("x_m"))) with lines linetype 1 title "0.4 and 0.3", \
     "" using "time_s":(on(0.2, column("x_m"))) with lines linetype 2 title "0.2 and 0.15"
set format x "%g"
set xlabel "time [s]"
set ylabel "speed [m/s]"
unset key
plot folder."/bar_friction.csv" using "time_s":(on(0.4, column("speed_m_per_s"))) with lines linetype 1, \
     "" using "time_s":(on(0.2, column("speed_m_per_s"))) with lines linetype 2
unset multiplot
