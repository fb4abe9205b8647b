# The bunny comes to rest: its kinetic energy against the impact's on a logarithmic scale, and the pairs that carry it.
height = 520
load style
set multiplot layout 2,1 margins 0.13,0.98,0.125,0.97 spacing 0,0.04
set xrange [0:6]
set format x ""
set logscale y
set format y "10^{%L}"
set yrange [1e-5:3]
set ylabel "kinetic energy / impact's"
set key top right
plot folder."/bunny_bowl.csv" using "time_s":(column("share") > 0 ? column("share") : NaN) with lines linetype 1 title "bowl and bunny", \
     0.001 with lines linetype 10 dashtype 2 title "0.1 %"
unset logscale y
set format y "%g"
set yrange [0:*]
set format x "%g"
set xlabel "time [s]"
set ylabel "pairs"
plot folder."/bunny_bowl.csv" using "time_s":"pairs" with lines linetype 1 title "all", \
     "" using "time_s":"held" with lines linetype 2 title "of these held"
unset multiplot
