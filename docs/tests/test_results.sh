#!/usr/bin/env bash
# Which results hold: a copy of the course command, in a folder with a space and an umlaut, with false programs that write down that they ran.
set -u
cd "$(dirname "$(readlink -f "$0")")/../.." || exit 1
failed=0
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
here="$scratch/Größe & mehr"
mkdir -p "$here/chapters/01_particle_plane/plots" "$here/chapters/solvers" "$here/common/"{scenes,meshes,experiments} "$here/cmake" \
    "$here/bin" "$here/build/release/bin"
cp course "$here"
cp cmake/*.sh cmake/packages.txt "$here/cmake"
: >"$here/chapters/01_particle_plane/main.cpp"
echo 'plot 1' >"$here/chapters/01_particle_plane/plots/drop.gp"
echo '{}' >"$here/common/scenes/ground.json"
: >"$here/build/release/build.ninja"
cd "$here" || exit 1
export PATH=$here/bin:$PATH
unset ENDURING_BUILD CI
printf '#!/bin/bash\n' >bin/cmake # builds nothing

program() { # NAME FOLDER: runs experiments drop and ground, or those that are named
    cat >"build/release/bin/$1" <<END
#!/bin/bash
echo "\$0" >>"$scratch/ran"
mkdir -p build/results/$2
for word in "\$@"; do [[ \$word == --scene ]] && echo other >build/results/$2/drop.csv; done
case " \$* " in *" elsewhere "*) exit 0 ;; *" ground "*) ;; *) echo 1 >build/results/$2/drop.csv ;; esac
[[ ! -e "$scratch/stop" ]] || exit 1
case " \$* " in *" drop "*) ;; *) echo 2 >build/results/$2/ground.csv ;; esac
[[ \$1 != --list ]] || printf '  drop  a drop\n  ground  a ground\n'
END
    chmod +x "build/release/bin/$1"
}
chmod +x bin/cmake
program base 00_base
program chapter01 01_particle_plane
program solvers solvers

expect() { # WHAT-RAN DESCRIPTION ARGUMENT...: which programs a command runs
    local got
    rm -f "$scratch/ran"
    ./course "${@:3}" >"$scratch/said" 2>&1 </dev/null
    got=$(grep -o '[a-z0-9]*$' "$scratch/ran" 2>/dev/null | paste -sd' ')
    if [[ $got != "$1" ]]; then
        printf 'FAILED: %s: "%s" ran, and should have been "%s"\n%s\n' "$2" "$got" "$1" "$(cat "$scratch/said")"
        failed=1
    fi
}
everything=(run --no-install)

expect 'base chapter01 solvers' "nothing is there yet" "${everything[@]}"
expect '' "all is there" "${everything[@]}"
touch build/release/bin/*
expect '' "the same programs, built again" "${everything[@]}"
echo '# more' >>build/release/bin/chapter01
expect 'chapter01' "another program" "${everything[@]}"
echo '{"dt": 1}' >common/scenes/ground.json
expect 'base chapter01 solvers' "another scene" "${everything[@]}"
touch common/scenes/ground.json
expect '' "the same scene, saved again" "${everything[@]}"
echo 'plot 2' >chapters/01_particle_plane/plots/drop.gp
expect 'chapter01' "another plot" "${everything[@]}"
echo '# comment' >chapters/01_particle_plane/chapter.md
expect '' "another text" "${everything[@]}"
rm build/results/solvers/drop.csv
expect 'solvers' "a result is gone" "${everything[@]}"

touch "$scratch/stop"
expect 'chapter01' "a run that breaks" run 1 --no-install
rm "$scratch/stop"
expect 'chapter01' "what broke does not hold" "${everything[@]}"
expect 'chapter01 chapter01' "one experiment, by the same program" run 1 drop --no-install
expect '' "that changes nothing" "${everything[@]}"
expect 'chapter01' "an own scene into the results" run 1 --no-install -- --scene own.json
expect 'chapter01' "they do not hold then" "${everything[@]}"
expect 'chapter01' "results elsewhere" run 1 --no-install -- elsewhere
expect '' "these change nothing" "${everything[@]}"
echo '# yet more' >>build/release/bin/chapter01
expect 'chapter01 chapter01' "one experiment, by another program" run 1 drop --no-install
expect 'chapter01' "the results are of two programs" "${everything[@]}"
if find build/results -name '*.part' | grep .; then echo "FAILED: a file .part stays"; failed=1; fi
exit $failed
