# The same force along k dt^2 = const, above the limit of DPF and below that of CPF (thesis figure 7.5).
height = 640
load style
set multiplot layout 4,2 margins 0.09,0.99,0.11,0.95 spacing 0.05,0.045
set xrange [0:4]
set yrange [-0.2:4.5]
set xtics 0,1
set ytics 0,1
methods = "DPF CPF"
steps = "0.004 0.005 0.007 0.010"
stiffnesses = "15313 9800 5000 2450"
do for [row=1:4] {
    do for [m=1:2] {
        set title (row == 1 ? word(methods, m) : "") offset 0,-0.6
        set format x (row == 4 ? "%g" : "")
        set xlabel (row == 4 ? "time [s]" : "")
        set format y (m == 1 ? "%g" : "")
        set ylabel (m == 1 ? "force [kN]" : "")
        dt = real(word(steps, row))
        set label 1 sprintf("Δt = %s s, k = %s N/m", word(steps, row), word(stiffnesses, row)) at graph 0.97,0.82 right textcolor rgb ink
        chosen(x) = strcol("figure") eq "7.5" && strcol("method") eq word(methods, m) && abs(column("dt_s") - dt) < 1e-9 ? x : NaN
        plot 0.7848 linetype 10, folder."/bar_force.csv" using "time_s":(chosen(column("force_n")/1000)) with lines linetype 3-m linewidth 0.8
    }
}
unset multiplot
