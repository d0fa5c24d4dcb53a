#include <sys/sysmacros.h>

#include <gtest/gtest.h>

#include "study/storage/local_disk.h"

namespace study::storage {
namespace network_drive_test {

// Lines as Linux 6.1 writes them.
constexpr const char* kMounts =
    "27 1 254:0 / / rw,relatime - ext4 /dev/vda rw,discard\n"
    "40 27 0:48 / /home/a\\040b rw,nosuid shared:22 - nfs4 server:/export rw,vers=4.2\n"
    "41 27 0:49 / /media/usb rw,nosuid shared:23 master:4 - fuseblk /dev/sdb1 rw\n"
    "42 27 0:50 / /run/user/1000/far rw - fuse.sshfs me@there: rw\n";

TEST(NetworkDrive, IsFoundByTheNumberOfItsDevice) {
  EXPECT_EQ(fileSystemOf(kMounts, makedev(254, 0)), "ext4");
  EXPECT_EQ(fileSystemOf(kMounts, makedev(0, 48)), "nfs4");
  EXPECT_EQ(fileSystemOf(kMounts, makedev(0, 49)), "fuseblk");
  EXPECT_EQ(fileSystemOf(kMounts, makedev(0, 50)), "fuse.sshfs");
  EXPECT_EQ(fileSystemOf(kMounts, makedev(0, 4)), "");
}

TEST(NetworkDrive, IsWhatAnotherComputerOrAnUnknownProgramServes) {
  for (const auto* type :
       {"nfs",
        "nfs4",
        "cifs",
        "smb3",
        "9p",
        "ceph",
        "afs",
        "virtiofs",
        "vboxsf",
        "fuse",
        "fuse.sshfs",
        "fuse.rclone",
        "fuse.ceph-fuse"}) {
    EXPECT_TRUE(isNetworkFileSystem(type)) << type;
  }
  for (const auto* type :
       {"",
        "ext4",
        "xfs",
        "btrfs",
        "zfs",
        "f2fs",
        "tmpfs",
        "overlay",
        "vfat",
        "exfat",
        "ntfs3",
        "fuseblk",
        "fuse.gocryptfs",
        "fuse.fuse-overlayfs"}) {
    EXPECT_FALSE(isNetworkFileSystem(type)) << type;
  }
}

}  // namespace network_drive_test
}  // namespace study::storage
