using System.Runtime.InteropServices;

namespace Nowpose.Gateway.Security;

/// <summary>Whom a file belongs to, which .NET does not tell.</summary>
static class FileOwner
{
    // linux/stat.h, the same on every processor: which fields are asked for, and where they stand.
    const int AtCurrentFolder = -100;
    const uint UidAndGid = 0x8 | 0x10;
    const int UidAt = 20;
    const int GidAt = 24;
    const int Size = 256;

    /// <summary>Whether somebody else owns it, and its group is this process's own. False where that cannot be told.</summary>
    public static bool IsOthersForOwnGroup(string path)
    {
        if (!OperatingSystem.IsLinux()) return false;
        var about = new byte[Size];
        try
        {
            if (AskFile(AtCurrentFolder, path, 0, UidAndGid, about) != 0) return false;
            return NumberAt(about, UidAt) != OwnUser() && NumberAt(about, GidAt) == OwnGroup();
        }
        catch (EntryPointNotFoundException)
        {
            // A system library from before 2018.
            return false;
        }
    }

    static uint NumberAt(byte[] about, int place) => BitConverter.ToUInt32(about, place);

    [DllImport("libc", EntryPoint = "statx")]
    static extern int AskFile(int folder, string path, int flags, uint mask, [Out] byte[] about);

    [DllImport("libc", EntryPoint = "geteuid")]
    static extern uint OwnUser();

    [DllImport("libc", EntryPoint = "getegid")]
    static extern uint OwnGroup();
}
