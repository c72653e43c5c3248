#!/bin/bash
# in_root.sh ROOT ARCHIVES COMMAND: runs a command of the shell in a root as debootstrap makes it, with this machine's network. ARCHIVES keeps
# the packages that apt fetches. FIELDFAB_BINDS names folders that are seen there, each as HERE or HERE=THERE. Started by ./dev in a mount and
# process namespace of its own: what is mounted goes, and what still runs ends, with the command.
set -euo pipefail
root=$1 archives=$2 command=$3
mount --make-rprivate /
mkdir -p "$archives/partial" "$root/dev/pts" "$root/proc" "$root/sys"
mount --bind /dev "$root/dev"
mount -t devpts -o newinstance,ptmxmode=0666 devpts "$root/dev/pts"
mount -t tmpfs tmpfs "$root/dev/shm"
mount -t proc proc "$root/proc"
mount --rbind /sys "$root/sys"
mount --bind "$archives" "$root/var/cache/apt/archives"
for bind in ${FIELDFAB_BINDS:-}; do
  mkdir -p "$root${bind#*=}"
  mount --bind "${bind%%=*}" "$root${bind#*=}"
done
cp -L /etc/resolv.conf /etc/hosts "$root/etc/"
apt-config dump | grep -i '^Acquire::.*prox' >"$root/etc/apt/apt.conf.d/90proxy" || true
echo 'APT::Keep-Downloaded-Packages "true";' >"$root/etc/apt/apt.conf.d/91keep"
# A mirror may be weeks behind; what it serves is still signed.
echo 'Acquire::Check-Valid-Until "false";' >"$root/etc/apt/apt.conf.d/92behind"
if [ -e /etc/ssl/certs/ca-certificates.crt ]; then  # whom this machine trusts, for npm: its network may have a certificate of its own
  mkdir -p "$root/etc/ssl"
  cp -L /etc/ssl/certs/ca-certificates.crt "$root/etc/ssl/this-machine.crt"
  export NODE_EXTRA_CA_CERTS=/etc/ssl/this-machine.crt
fi
export DEBIAN_FRONTEND=noninteractive PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8
chroot "$root" apt-get update -q
exec chroot "$root" /bin/bash -c "$command"
