# The look of every plot of the course: an SVG without a background, in tones that read on a white page and on a dark one.
# A script begins with `load style`, before it `height = 560` if it is not 430 high, then reads its tables as
# folder."/NAME.csv". Line types:
#   1 blue: continuous penalties (CPF)   2 terracotta: discrete penalties (DPF)   3 green   4 ochre   5 violet   6 grey
#   10 a thin dashed line for theory and limits
if (!exists("height")) height = 430
set terminal svg enhanced size 760,height font "DejaVu Sans,Verdana,Helvetica,sans-serif,14" linewidth 1.4 rounded \
    dashlength 0.7    # no background: the page shows through
set output output
set datafile separator ","
set encoding utf8

ink = "#808890"    # halfway between black and white: text and frame on either page
set linetype 1 linecolor rgb "#3f8fd0" linewidth 1.6 pointtype 7 pointsize 0.5
set linetype 2 linecolor rgb "#d9673f" linewidth 1.6 pointtype 5 pointsize 0.5
set linetype 3 linecolor rgb "#4aa36b" linewidth 1.6 pointtype 9 pointsize 0.6
set linetype 4 linecolor rgb "#c9982f" linewidth 1.6 pointtype 13 pointsize 0.6
set linetype 5 linecolor rgb "#9a78c8" linewidth 1.6 pointtype 11 pointsize 0.6
set linetype 6 linecolor rgb "#8a8f98" linewidth 1.6 pointtype 3 pointsize 0.5
set linetype 10 linecolor rgb ink linewidth 1.0 dashtype 2

set border 3 linecolor rgb ink linewidth 0.8
set tics nomirror out scale 0.6 textcolor rgb ink
set xlabel textcolor rgb ink
set ylabel textcolor rgb ink
set y2label textcolor rgb ink
set cblabel textcolor rgb ink
set title textcolor rgb ink font ",15"
set key textcolor rgb ink samplen 2 spacing 1.15 noautotitle
set grid linecolor rgb "#d0808890" linewidth 0.6 dashtype 1
set palette defined (0 "#3f6fb5", 0.5 "#8fb5a0", 1 "#d9673f")
set samples 400
