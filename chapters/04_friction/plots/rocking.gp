# Share of the weight on the uphill half of a low block and of a cube.
load style
set xlabel "time [s]"
set ylabel "share of the weight uphill"
set xrange [0:4]
set yrange [0:1.1]
on(h, x) = column("height_m") == h ? x : NaN
plot 0.5 linetype 10, folder."/rocking.csv" using "time_s":(on(1, column("uphill_share"))) with lines linetype 2 title "cube", \
     "" using "time_s":(on(0.1, column("uphill_share"))) with lines linetype 1 title "block"
