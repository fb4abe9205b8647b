# The vertex that carries a rolling wheel, its lever in three moments of a step, and the push on it.
height = 370
load style
set multiplot layout 1,3 margins 0.01,0.99,0.03,0.9 spacing 0.02,0
unset border
unset tics
unset grid
unset key
set size ratio -1
set xrange [-1.3:1.3]
set yrange [-2:1.3]
lever_ink = "#d9673f"
push_ink = "#3f8fd0"
file = folder."/levers_drawn.csv"
do for [i = 0:2] {
    tau = i / 2.0
    stats file using (column("tau") == tau && column("carries") == 1 ? column("x") : NaN) nooutput
    x = STATS_min
    stats file using (column("tau") == tau && column("carries") == 1 ? column("y") : NaN) nooutput
    y = STATS_min
    set title sprintf("lever of the %s", word("start middle end", i + 1))
    set object 1 circle at 0,0 size 1 fillstyle solid 0.12 border rgb ink fillcolor rgb ink
    set arrow 1 from -1.25,-1 to 1.25,-1 nohead linecolor rgb ink linewidth 1.6 dashtype 1
    set arrow 2 from 0,0 to x,y linecolor rgb lever_ink linewidth 2 dashtype 1
    set arrow 3 from x,y-0.75 to x,y-0.04 linecolor rgb push_ink linewidth 2.4 dashtype 1
    set arrow 4 from x,y to x,0.35 nohead linecolor rgb push_ink linewidth 1 dashtype 2
    set arrow 5 from -0.35,1.15 to 0.35,1.15 linecolor rgb ink linewidth 1 dashtype 1
    set object 2 circle at 0,0 size 0.04 fillstyle solid 1 border rgb ink fillcolor rgb ink
    set label 1 "r" at x/2 - 0.13, y/2 - 0.05 center textcolor rgb lever_ink
    set label 2 "N" at x + 0.13, y - 0.55 center textcolor rgb push_ink
    set label 3 (x > 0.01 ? sprintf("%.2f R ahead: brakes", x) : "under the centre") at 0,-1.88 center textcolor rgb ink
    shown(of, carries) = column("tau") == tau && column("carries") == carries ? column(of) : NaN
    plot file using (shown("x", 0)):(shown("y", 0)) with points pointtype 7 pointsize 0.4 linecolor rgb ink, \
         file using (shown("x", 1)):(shown("y", 1)) with points pointtype 7 pointsize 0.9 linecolor rgb lever_ink
}
unset multiplot
