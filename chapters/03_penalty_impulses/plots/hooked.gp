# A cube that slides without friction: on a plane, and on triangles that form the same plane.
height = 480
load style
set multiplot layout 2,1 margins 0.12,0.98,0.145,0.97 spacing 0,0.04
set xrange [0:1.5]
set key top left
on(f, x) = strcol("floor") eq f ? x : NaN
set format x ""
set ylabel "way [m]"
plot folder."/hooked.csv" using "time_s":(on("plane", column("x_m"))) with lines linetype 3 title "plane", \
     "" using "time_s":(on("triangles", column("x_m"))) with lines linetype 1 title "triangles"
set format x "%g"
set xlabel "time [s]"
set ylabel "speed [m/s]"
unset key
plot 0 linetype 10, folder."/hooked.csv" using "time_s":(on("plane", column("speed_m_per_s"))) with lines linetype 3, \
     "" using "time_s":(on("triangles", column("speed_m_per_s"))) with lines linetype 1
unset multiplot
