# Depth over one step (thesis figure 5.1): filled what CPF integrates, framed what DPF takes for it.
height = 300
load style
set multiplot layout 1,5 margins 0.09,0.985,0.23,0.88 spacing 0.03,0
set xrange [0:1]
set yrange [-95:45]
set xtics ("0" 0, "½" 0.5, "1" 1)
set xlabel "τ"
panel = "abcde"
what = "'falling in' 'sinking' 'rising out' 'rising' 'inside twice'"
do for [i=1:5] {
    set title panel[i:i].") ".word(what, i) offset 0,-0.5
    set ylabel (i == 1 ? "depth [mm]" : "") offset 1,0
    if (i > 1) { set format y "" }
    of_panel(x) = strcol("panel") eq panel[i:i] ? x : NaN
    plot 0 linetype 10, \
         folder."/impulse_shape.csv" using "tau":(of_panel(-column("inside_mm"))) with filledcurves y1=0 linetype 1 fillstyle solid 0.35, \
         "" using "tau":(of_panel(column("depth_mm"))) with lines linetype 1, \
         "" using "tau":(of_panel(-column("dpf_mm"))) with lines linetype 2 dashtype 2
}
unset multiplot
