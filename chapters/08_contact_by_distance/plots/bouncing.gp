# A ball that falls a metre, with four coefficients of restitution.
load style
set xlabel "time [s]"
set ylabel "height [m]"
set xrange [0:3]
set yrange [-0.03:1.03]
set key above
of(e) = column("e") == e ? column("height_m") : NaN
data = folder."/bouncing.csv"
plot data using "time_s":(of(0.9)) with lines linetype 1 title "e = 0.9", \
     data using "time_s":(of(0.75)) with lines linetype 2 title "0.75", \
     data using "time_s":(of(0.5)) with lines linetype 3 title "0.5", \
     data using "time_s":(of(0.25)) with lines linetype 4 title "0.25"
