# The same block on the analytic slope and on one of triangles.
height = 480
load style
set multiplot layout 2,1 margins 0.12,0.98,0.145,0.97 spacing 0,0.04
set xrange [0:2]
set key bottom right
on(f, x) = strcol("floor") eq f ? x : NaN
set format x ""
set ylabel "way [m]"
plot folder."/mesh_slope.csv" using "time_s":(on("plane", column("distance_m"))) with lines linetype 3 title "plane", \
     "" using "time_s":(on("triangles", column("distance_m"))) with lines linetype 1 title "triangles"
set format x "%g"
set xlabel "time [s]"
set ylabel "speed [m/s]"
unset key
plot 0 linetype 10, folder."/mesh_slope.csv" using "time_s":(on("plane", column("speed_m_per_s"))) with lines linetype 3, \
     "" using "time_s":(on("triangles", column("speed_m_per_s"))) with lines linetype 1
unset multiplot
