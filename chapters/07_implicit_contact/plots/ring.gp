# What is left of a departure from rest after each step.
load style
set xlabel "steps"
set ylabel "departure left"
set xrange [0:12]
set yrange [-1:1]
set key above
of(h, a) = column("h") == h && column("centre") == a ? column("left") : NaN
data = folder."/ring.csv"
plot 0 linetype 10, \
     data using "step":(of(1, 0.5)) with linespoints linetype 3 title "CPF, h = 1", \
     data using "step":(of(16, 0.5)) with linespoints linetype 1 title "CPF, h = 16", \
     data using "step":(of(100, 0.5)) with linespoints linetype 5 title "CPF, h = 100", \
     data using "step":(of(100, 1)) with linespoints linetype 2 title "DPF, h = 100"
