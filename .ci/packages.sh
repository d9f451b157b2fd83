#!/usr/bin/env bash
# Installs what the steps need besides what ./muelle installs, and says so.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
begin "packages"
missing=()
for package in clang clang-tidy clang-format; do
  command -v "${package/%clang/clang++}" >/dev/null || missing+=("$package")
done
if [[ ${#missing[@]} -gt 0 ]]; then
  [[ $(id -u) -eq 0 ]] || { echo "packages.sh: as root type: apt-get install ${missing[*]}" >&2; exit 2; }
  echo "packages.sh: these packages are missing and get installed: ${missing[*]}"
  export DEBIAN_FRONTEND=noninteractive
  apt-get update -qq
  apt-get install --yes -qq --no-install-recommends "${missing[@]}" >/dev/null
fi
