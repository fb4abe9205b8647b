# Which results are there, who made them, and whether they still hold. Read by `course`.
# shellcheck shell=bash disable=SC2154  # release and quick are set in course
#   .made_by    the hash of the program that made all of them; the book refuses those of another program (docs/checks.py)
#   .complete   the hash of the program and of all that it reads, and the names of the files that a whole run left
# While a program runs, neither is there: what a run leaves that was stopped holds for nobody.

results_of() { # FOLDER: quick results never mix with full ones
    if [[ $quick == yes ]]; then echo "build/results-quick/$1"; else echo "build/results/$1"; fi
}

maker_of() { # FOLDER: what the program of a chapter is known by
    sha256sum "$release/bin/$(program_of "$1")" | cut -d' ' -f1
}

# What decides about results: the program, the scenes, meshes and plots that it reads, and the programs that draw for it.
cause_of() { # FOLDER
    local drawer folders=(common/scenes common/meshes common/experiments)
    [[ $1 == 00_base ]] || folders+=("chapters/$1")
    {
        maker_of "$1"
        find "${folders[@]}" -type f ! -path '*/tests/*' ! -name '*.md' ! -name '*.toml' ! -name '*.[ch]pp' -print0 | LC_ALL=C sort -z | xargs -0 sha256sum
        for drawer in gnuplot ffmpeg; do ! command -v "$drawer" >/dev/null || echo "$drawer"; done
    } | sha256sum | cut -d' ' -f1
}

results_hold() { # FOLDER RESULTS
    local cause file
    [[ -e $2/.complete && $(cat "$2/.made_by" 2>/dev/null) == "$(maker_of "$1")" ]] || return 1
    {
        read -r cause
        [[ $cause == "$(cause_of "$1")" ]] || return 1
        while read -r file; do [[ -e $2/$file ]] || return 1; done
    } <"$2/.complete"
}

take_stamps_away() { # RESULTS
    local stamp
    rm -f "$1"/.*.part
    [[ ! -d $1 ]] || touch "$1/.started.part"
    for stamp in .complete .made_by; do [[ ! -e $1/$stamp ]] || mv "$1/$stamp" "$1/$stamp.part"; done
}

stamp() { # FOLDER RESULTS: after a whole run
    rm -f "$2"/.*.part
    {
        cause_of "$1"
        (cd "$2" && find . -maxdepth 1 -type f ! -name '.*' | sort)
    } >"$2/.complete.part"
    maker_of "$1" >"$2/.made_by"
    mv "$2/.complete.part" "$2/.complete"
}

# After a part of the experiments, or after what went elsewhere: the results are as before if none was touched, or if the same program
# has made some of them anew from what the experiments read.
put_stamps_back() { # FOLDER RESULTS
    local touched stamp
    [[ -d $2 ]] || return 0
    touched=$([[ ! -e $2/.started.part ]] || find "$2" -maxdepth 1 -type f ! -name '.*' -newer "$2/.started.part" -print -quit)
    if [[ -z $touched || (${#passed[@]} -eq 0 && $(cat "$2/.made_by.part" 2>/dev/null) == "$(maker_of "$1")") ]]; then
        for stamp in .complete .made_by; do [[ ! -e $2/$stamp.part ]] || mv "$2/$stamp.part" "$2/$stamp"; done
    fi
    rm -f "$2"/.*.part
}
