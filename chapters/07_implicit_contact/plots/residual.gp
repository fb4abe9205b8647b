# The residual on the bodies over the steps of Newton's method, for the hardest step of three scenes.
load style
set multiplot layout 1,3
set logscale y
set format y "10^{%L}"
set yrange [1e-8:5]
set xrange [0:60]
set xtics 20
set xlabel "Newton steps"
set ylabel "residual"
set key at graph 1.05, 0.97 samplen 1
data = folder."/residual.csv"
of(s, h) = strcol("scene") eq s && strcol("help") eq h ? column("residual") : NaN
do for [s in "stack heap wedged"] {
  set title s
  if (s ne "stack") { set key off }
  plot 1e-6 linetype 10 notitle, \
       data using "newton_steps":(of(s, "lagging alone")) with linespoints linetype 3 title "lagging alone", \
       data using "newton_steps":(of(s, "with mixing")) with linespoints linetype 1 title "mixing"
  unset ylabel
}
unset multiplot
