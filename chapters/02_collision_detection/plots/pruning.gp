# Pairs left to the query, and the time of finding and answering them, against the faces of each body.
height = 380
load style
set multiplot layout 1,2 margins 0.1,0.98,0.19,0.95 spacing 0.13,0
set logscale xy
set format xy "10^{%L}"
set xlabel "faces of each body"
set xrange [50:150000]
set key bottom right
of(name, what) = strcol("method") eq name ? column(what) : NaN
data = folder."/pruning.csv"
set ylabel "pairs"
plot data using "faces":(of("all pairs", "pairs")) with linespoints linetype 2 title "all pairs", \
     "" using "faces":(of("tree", "pairs")) with linespoints linetype 1 title "boxes, tree"
set key bottom right
set ylabel "time [ms]"
plot data using "faces":(of("all pairs", "time_ms")) with linespoints linetype 2 title "all pairs", \
     "" using "faces":(of("boxes", "time_ms")) with linespoints linetype 4 title "boxes", \
     "" using "faces":(of("tree", "time_ms")) with linespoints linetype 1 title "tree", \
     "" using "faces":(of("Bullet's tree", "time_ms")) with linespoints linetype 6 title "Bullet's tree"
unset multiplot
