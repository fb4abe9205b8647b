# The fall of the bunny: energy, and how deep the pairs are.
height = 480
load style
set multiplot layout 2,1 margins 0.12,0.98,0.145,0.97 spacing 0,0.04
set xrange [0:3]
set format x ""
set ylabel "energy [J]"
set yrange [0:*]
set key top right
plot folder."/bunny_bowl.csv" using "time_s":"total_j" with lines linetype 3 title "all but the penalty's", \
     "" using "time_s":"kinetic_j" with lines linetype 1 title "kinetic"
set format x "%g"
set xlabel "time [s]"
set ylabel "deepest [mm]"
plot folder."/bunny_bowl.csv" using "time_s":(1000*column("depth_max_m")) with lines linetype 1 title "pair, planes counted", \
     "" using "time_s":(1000*column("plane_depth_m")) with lines linetype 2 title "vertex of the bowl in the ground"
unset multiplot
