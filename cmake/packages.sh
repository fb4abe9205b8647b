# The list of packages for `course`: which a group has, which are missing, what they would cost, and their installation.
# shellcheck shell=bash disable=SC2046,SC2086,SC2154,SC2317  # names of groups and packages are one word each; `install` is the reader's, in course

groups() { sed -n 's/^\[\([a-z]*\)\].*/\1/p' cmake/packages.txt; }

what_for() { sed -n "s/^\[$1\] //p" cmake/packages.txt; } # GROUP

packages_of() { # GROUP...: a line each, as in the list
    LC_ALL=C awk -v groups=" $* " '/^\[/ { ours = index(groups, " " substr($1, 2, length($1) - 2) " ") } ours && /^[a-z]/' cmake/packages.txt
}

has_apt() { command -v apt-get >/dev/null && command -v dpkg-query >/dev/null; }

missing_packages() { # GROUP...
    local wanted installed
    wanted=$(packages_of "$@" | cut -d' ' -f1 | sort)
    installed=$({ dpkg-query -W -f '${db:Status-Status} ${Package}\n' $wanted 2>/dev/null || true; } | # it fails when it has never heard of one
        awk '$1 == "installed" { print $2 }' | sort -u)
    comm -23 <(echo "$wanted") <(echo "$installed") | while read -r package; do
        # npm comes with Node.js where that is not Debian's, and Debian's npm cannot be installed beside it
        [[ $package == npm ]] && command -v npm >/dev/null || echo "$package"
    done
}

# Installs what is missing, and says before what and how much. A command cannot do without GROUPS: where they cannot be installed, it ends.
# What is missing of OTHERS costs only itself.
need() { # "GROUP..." ["OTHER..."]
    local missing=() as_root=() rate=''
    [[ $install == yes ]] || return 0
    if ! has_apt; then
        say "This system has no apt. Going on with what is here; these (Debian's names) are needed:"
        packages_of $1 ${2:-} | sed 's/^/  /'
        return 0
    fi
    mapfile -t missing < <(missing_packages $1 ${2:-})
    ((${#missing[@]})) || return 0
    if (($(id -u) != 0)); then
        if ! command -v sudo >/dev/null || ! sudo true; then
            ask_administrator "$1" "${missing[@]}"
            return 0
        fi
        as_root=(sudo)
    fi
    update_lists
    leave_out_unknown
    if ((${#missing[@]})); then
        say_plan $1 ${2:-}
        "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${missing[@]}" ||
            say "apt could not install them."
    fi
    mapfile -t missing < <(missing_packages $1)
    if [[ -n ${missing[*]} ]]; then say "This command cannot do without ${missing[*]}"; exit 1; fi
}

ask_administrator() { # "GROUP..." PACKAGE...
    say "Packages are missing, and you are not root and may not use sudo. Please ask an administrator for:"
    echo "  apt-get install --no-install-recommends ${*:2}"
    if [[ -n $(missing_packages $1) ]]; then
        echo "Without them this command cannot run (--no-install tries). docs/your_machine.md tells of other ways, as a container."
        exit 2
    fi
    echo "Going on without them."
}

update_lists() { # apt's lists of packages; sets rate [MB/s], where enough came to tell
    local said
    said=$("${as_root[@]}" env LC_ALL=C apt-get update 2>&1) || printf '%s\n' "$said" >&2
    rate=$(sed -nE 's/^Fetched ([0-9.,]+ [kM]?B) in [^(]*\(([0-9.,]+ [kM]?B)\/s\).*/\1 \2/p' <<<"$said" | tr -d , |
        LC_ALL=C awk '{ unit["B"] = 1e-6; unit["kB"] = 1e-3; unit["MB"] = 1; if ($1 * unit[$2] > 1) print $3 * unit[$4] }')
}

leave_out_unknown() { # of missing: what this archive does not have; who needs it says so
    local known unknown
    known=$(printf '%s\n' "${missing[@]}" | grep -xF -f <(apt-cache pkgnames) || true)
    unknown=$(grep -vxF -f <(echo "$known") <(printf '%s\n' "${missing[@]}") || true)
    [[ -z $unknown ]] || say "This system's archive does not have" $unknown
    mapfile -t missing < <(grep -v '^$' <<<"$known")
}

# What apt would install with some packages: how many, MB to download, MB on the disk.
cost_of() { # PACKAGE...
    apt-cache show --no-all-versions $(LC_ALL=C apt-get -s install --no-install-recommends "$@" | awk '/^Inst/ { print $2 }') |
        LC_ALL=C awk '/^Package:/ { count++ } /^Size:/ { size += $2 / 1e6 } /^Installed-Size:/ { disk += $2 / 1e3 }
             END { printf "%d %.0f %.0f\n", count, size, disk }'
}

say_plan() { # GROUP...; the time is that of the download, at the rate that the lists came with, and of dpkg, which unpacks some 15 MB a second
    local group count size disk
    say "To install"
    for group in "$@"; do
        [[ -z $(missing_packages "$group") ]] || echo "   $group: $(what_for "$group")"
    done
    echo "   ${missing[*]}"
    read -r count size disk < <(cost_of "${missing[@]}")
    LC_ALL=C awk -v count="$count" -v size="$size" -v disk="$disk" -v rate="${rate:-2}" 'BEGIN {
        minutes = (size / rate + disk / 15) / 60
        printf "   with all that they stand on %d packages: %d MB to download, %d MB on the disk; %s, at %.1f MB a second\n",
            count, size, disk, minutes < 1 ? "less than a minute" : sprintf("about %d min", minutes + 0.5), rate }'
}

# Whether something is here now that a build folder had to do without.
found_since() { # BUILD-FOLDER
    local without=()
    [[ -s $1/left_out.txt ]] || return 1
    has_apt || return 0 # CMake looks
    mapfile -t without <"$1/left_out.txt"
    { dpkg-query -W -f '${db:Status-Status} ${Package}\n' "${without[@]}" 2>/dev/null || true; } |
        grep -qxF -f <(printf 'installed %s\n' "${without[@]}")
}
