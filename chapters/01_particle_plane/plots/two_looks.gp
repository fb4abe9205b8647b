# What each method adds up in one step: CPF the area under the depth, DPF the end's depth for the whole step.
height = 320
load style
set multiplot layout 1,3 margins 0.09,0.98,0.22,0.87 spacing 0.05,0
set xrange [0:1]
set yrange [-24:55]
set xtics 0,0.5
set xlabel "time in the step"
set key at graph 0.98,0.98 samplen 1.5
do for [i=0:2] {
    stats [*:*][*:*] folder."/two_looks.csv" using "from_mm" every ::i::i nooutput
    from = STATS_min
    stats [*:*][*:*] folder."/two_looks.csv" using "to_mm" every ::i::i nooutput
    to = STATS_min
    depth(t) = -(from + t*(to - from))
    discrete = to < 0 ? -to : 0
    set title word("enters sinks leaves", i + 1) offset 0,-0.6
    set ylabel (i == 0 ? "depth inside [mm]" : "")
    set format y (i == 0 ? "%g" : "")
    plot (discrete) with filledcurves y1=0 linecolor rgb "#a0d9673f" title (i == 2 ? "DPF" : ""), \
         (depth(x) > 0 ? depth(x) : 0) with filledcurves y1=0 linecolor rgb "#303f8fd0" title (i == 2 ? "CPF" : ""), \
         discrete linetype 2 linewidth 1, depth(x) linetype 6, 0 linetype 10
}
unset multiplot
