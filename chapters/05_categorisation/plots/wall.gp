# How far a plate runs into a wall when hooked pairs push, and when they are dropped.
height = 380
load style
set xlabel "time [s]"
set ylabel "foremost vertex [m]"
set yrange [-0.15:0.35]
set key top right
set xrange [0:0.3]
depth(w) = strcol("hooked_pairs") eq w ? column("depth_m") : NaN
plot 0 linetype 10, 0.18 linetype 10 title "the wall's two sides", \
     folder."/wall.csv" using "time_s":(depth("pushed")) with lines linetype 1 title "hooked pairs pushed", \
     "" using "time_s":(depth("dropped")) with lines linetype 2 title "hooked pairs dropped"
