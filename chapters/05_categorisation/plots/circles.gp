# Four corners, and around each three rings over all directions: where a floor can touch, and what two rules say.
height = 780
load style
set multiplot layout 2,2 margins 0.02,0.98,0.02,0.92 spacing 0.04,0.09
unset border
unset tics
unset grid
unset key
set size ratio -1
set xrange [-2.15:2.15]
set yrange [-2.15:2.15]
yes = "#3f8fd0"
no = "#e09040"
file = folder."/circles.csv"
do for [corner in "acute right obtuse flat"] {
    o = corner eq "acute" ? 40 : corner eq "right" ? 90 : corner eq "obtuse" ? 160 : 180
    set angles degrees
    set title sprintf("%s corner, %d°", corner, o)
    set object 1 circle at 0,0 size 1 arc [90 - o / 2 : 90 + o / 2] fillstyle solid 0.35 border rgb ink fillcolor rgb ink
    set arrow 1 from 0,0 to 0.75*cos(-o/2), 0.75*sin(-o/2) linecolor rgb ink linewidth 1.6
    set arrow 2 from 0,0 to 0.75*cos(180+o/2), 0.75*sin(180+o/2) linecolor rgb ink linewidth 1.6
    set arrow 3 from 0,0 to 0,-0.75 linecolor rgb "#4aa36b" linewidth 1.6
    set label 1 "possible" at 0,1.3 center font ",11" textcolor rgb ink
    set label 2 "average" at 0,1.62 center font ",11" textcolor rgb ink
    set label 3 "span" at 0,1.94 center font ",11" textcolor rgb ink
    ring(verdict, wanted, r, x) = strcol("corner") eq corner && column(verdict) == wanted && abs(column("lean_deg")) < 155 ? r * x : NaN
    plot for [i=1:3] file using (ring(word("possible average span", i), 0, 0.98 + 0.32 * i, column("x"))):(ring(word("possible average span", i), 0, 0.98 + 0.32 * i, column("y"))) with points pointtype 7 pointsize 0.45 linecolor rgb no, \
         for [i=1:3] file using (ring(word("possible average span", i), 1, 0.98 + 0.32 * i, column("x"))):(ring(word("possible average span", i), 1, 0.98 + 0.32 * i, column("y"))) with points pointtype 7 pointsize 0.45 linecolor rgb yes
}
unset multiplot
